// st-ethernet-ip scans the box as a PLC does: cyclic data both ways.
"use strict";

const assert = require("node:assert");
const net = require("node:net");
const { IO } = require("st-ethernet-ip");

const HOST = process.argv[2];
// an address of its own, as others may scan on this computer, too
const LOCAL = HOST.replace(/\d+$/, (n) => String((Number(n) + 100) % 200));
const GIVE_UP_MS = 60000;
const RPI_MS = 10;
const TO_ROBOT = { assembly: 112, size: 224 };
const FROM_ROBOT = { assembly: 100, size: 480 };
const RUNNING = 7;

setTimeout(() => {
  throw new Error("gave up");
}, GIVE_UP_MS).unref();

async function until(what, condition) {
  while (!condition()) {
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  console.log(what);
}

async function main() {
  const scanner = new IO.Scanner(2222, LOCAL);
  const robot = scanner.addConnection(
    {
      configInstance: { assembly: 1, size: 0 },
      outputInstance: TO_ROBOT,
      inputInstance: FROM_ROBOT,
    },
    RPI_MS,
    HOST,
  );
  let lost = 0;
  robot.on("disconnected", () => lost++);
  await until("connected", () => robot.connected);

  const input = () => robot.inputData;
  assert.deepStrictEqual([...input().subarray(0, 2)], [5, 24], "version");
  assert.strictEqual(input().readUInt8(4), RUNNING, "robot mode");
  assert.strictEqual(input().readFloatLE(20), 1, "speed slider");
  const shoulder = input().readFloatLE(104);
  console.log("shoulder, rad:", shoulder);
  assert.ok(Math.abs(shoulder) > 0.1, "shoulder");

  // outputs 0 and 2 by a mask, input register 0 for a script
  const output = Buffer.from(robot.outputData);
  output.writeUInt8(0b0111, 8);
  output.writeUInt8(0b0101, 10);
  output.writeInt32LE(-42, 28);
  robot.outputData = output;
  await until("outputs 0 and 2 are on", () => (input().readUInt8(34) & 0b0111) === 0b0101);

  const uploading = net.connect(30002, HOST, () =>
    uploading.write(
      "def twice():\n" +
        "  while True:\n" +
        "    write_output_integer_register(3, 2 * read_input_integer_register(0))\n" +
        "    sync()\n" +
        "  end\n" +
        "end\n",
    ),
  );
  uploading.on("data", () => {});
  await until("a script doubles what the scanner writes", () => input().readInt32LE(300) === -84);
  const next = Buffer.from(robot.outputData);
  next.writeInt32LE(1000, 28);
  robot.outputData = next;
  await until("and follows it", () => input().readInt32LE(300) === 2000);

  assert.strictEqual(lost, 0, "lost connections");
  await robot.tcpController.disconnect();
  process.exit(0);
}

main();
