// Prints what Khronos' validator says of each file: node validate.js FILE...
const fs = require('fs');
const path = require('path');
const validator = require(path.join(process.cwd(), 'node_modules', 'gltf-validator'));

(async () => {
  const issues = {};
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    issues[file] = report.issues.messages;
  }
  console.log(JSON.stringify(issues));
})();
