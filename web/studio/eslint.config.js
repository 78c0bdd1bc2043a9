import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import eslint from "@eslint/js";
import tseslint from "typescript-eslint";

export default tseslint.config(
    { ignores: ["node_modules", "build.mjs", "eslint.config.js"] },
    {
        files: ["src/**/*.{ts,tsx}", "test/**/*.ts"],
        extends: [
            eslint.configs.recommended,
            tseslint.configs.strictTypeChecked,
            tseslint.configs.stylisticTypeChecked,
        ],
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
            // node:test runs what it is given and reports how it ended.
            "@typescript-eslint/no-floating-promises": [
                "error",
                {
                    allowForKnownSafeCalls: [
                        {
                            from: "package",
                            name: ["test", "before", "after"],
                            package: "node:test",
                        },
                    ],
                },
            ],
        },
    },
);
