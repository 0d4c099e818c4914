// Errors and warnings of the Khronos validator: node gltf_issues.js FOLDER_OF_VALIDATOR FILE...
const fs = require("fs");
const path = require("path");
const validator = require(path.join(process.argv[2], "node_modules", "gltf-validator"));

(async () => {
  const answers = {};
  for (const file of process.argv.slice(3)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
    const found = report.issues.messages.filter((issue) => issue.severity < 2);
    answers[file] = found.map((issue) => `${issue.code} at ${issue.pointer}: ${issue.message}`);
  }
  console.log(JSON.stringify(answers));
})();
