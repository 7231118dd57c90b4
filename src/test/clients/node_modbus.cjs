// modbus-serial against the Modbus server: registers, coils, the robot's state, refusals.
"use strict";

const assert = require("node:assert");
const net = require("node:net");
const ModbusRTU = require("modbus-serial");

const HOST = process.argv[2];
const GIVE_UP_MS = 60000;
const ILLEGAL_ADDRESS = 2;

setTimeout(() => {
  throw new Error("gave up");
}, GIVE_UP_MS).unref();

/** Connects to port 502, or to the one that a box without the right to it uses. */
async function connected() {
  for (const port of [502, 1502]) {
    const client = new ModbusRTU();
    try {
      await client.connectTCP(HOST, { port });
      client.setTimeout(5000);
      return client;
    } catch (e) {
      console.log(`port ${port}: ${e.message}`);
    }
  }
  throw new Error(`no Modbus server at ${HOST}`);
}

function check(what, expected, found) {
  console.log(what, found);
  assert.deepStrictEqual(found, expected, what);
}

async function refused(what, asking) {
  await assert.rejects(asking, (e) => e.modbusCode === ILLEGAL_ADDRESS, what);
  console.log(what, "refused");
}

function runScript(text) {
  return new Promise((resolve, reject) => {
    const uploading = net.connect(30002, HOST, () => uploading.write(text));
    uploading.once("data", () => resolve(uploading.destroy()));
    uploading.once("error", reject);
  });
}

async function main() {
  const client = await connected();
  const words = async (at, count) => (await client.readHoldingRegisters(at, count)).data;

  await client.writeRegister(128, 1234);
  check("register 128", [1234], await words(128, 1));
  await client.writeRegisters(200, [1, 0xffff, 3]);
  check("registers 200 to 202", [1, 0xffff, 3], await words(200, 3));
  check("the same as inputs", [1, 0xffff, 3], (await client.readInputRegisters(200, 3)).data);

  await client.writeCoil(16, true);
  check("output 0", [true, false], (await client.readCoils(16, 2)).data.slice(0, 2));
  await client.writeCoils(40, [true, false, true]);
  check("configurable outputs", [5], await words(31, 1));
  check("robot mode", [7], await words(258, 1));

  await runScript(
    "def plus_one():\n  write_port_register(141, read_port_register(128) + 1)\nend\n",
  );
  while ((await words(141, 1))[0] !== 1235) {
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
  console.log("a script has read and written");

  await refused("nothing there", client.readHoldingRegisters(50, 1));
  await refused("an input", client.writeCoil(0, true));
  check("still connected", [1234], await words(128, 1));
  client.close(() => process.exit(0));
}

main();
