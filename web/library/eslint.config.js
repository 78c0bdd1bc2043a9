import eslint from "@eslint/js";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import tseslint from "typescript-eslint";

export default tseslint.config({ ignores: ["node_modules"] }, eslint.configs.recommended, {
    files: ["src/**/*.ts", "test/**/*.ts"],
    extends: [tseslint.configs.strictTypeChecked, tseslint.configs.stylisticTypeChecked],
    languageOptions: {
        parserOptions: {
            projectService: true,
            tsconfigRootDir: dirname(fileURLToPath(import.meta.url)),
        },
    },
    rules: {
        "@typescript-eslint/no-unused-vars": ["error", { varsIgnorePattern: "^_" }],
        // Say what an index is known to hold; `!` would say it without a type.
        "@typescript-eslint/non-nullable-type-assertion-style": "off",
    },
});
