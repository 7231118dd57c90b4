package org.pendant.controller.outside;

import org.pendant.controller.value.ScriptError;

/**
 * The ways out that a controller was given. It asks for something, goes on with its frames, and
 * looks once a frame whether it has come; nothing here ever waits.
 *
 * @param sockets opens TCP connections (manual 18.54 to 18.66)
 * @param rpc calls functions of other computers (manual 8, 18.40)
 * @param modbus speaks to Modbus devices (manual 18.18 to 18.31)
 * @param toolSerial what the tool's serial line leads to (manual 18.50)
 */
public record Doors(SocketDoor sockets, RpcDoor rpc, ModbusDoor modbus, ToolSerialDoor toolSerial) {
  /** No way out: everything is refused. */
  public static final Doors NONE =
      new Doors(
          (host, port) -> {
            throw missing();
          },
          url -> {
            throw missing();
          },
          ModbusDoor.NONE,
          ToolSerialDoor.NONE);

  /** With nothing at the tool's serial line. */
  public Doors(SocketDoor sockets, RpcDoor rpc, ModbusDoor modbus) {
    this(sockets, rpc, modbus, ToolSerialDoor.NONE);
  }

  /** Without a way to Modbus devices. */
  public Doors(SocketDoor sockets, RpcDoor rpc) {
    this(sockets, rpc, ModbusDoor.NONE);
  }

  /** With something at the tool's serial line. */
  public Doors withToolSerial(ToolSerialDoor door) {
    return new Doors(sockets, rpc, modbus, door);
  }

  static ScriptError missing() {
    return new ScriptError("no-outside", "this controller has no way to the outside");
  }
}
