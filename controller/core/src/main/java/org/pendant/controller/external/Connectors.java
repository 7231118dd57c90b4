package org.pendant.controller.external;

import static org.pendant.controller.external.ExternalTexts.text;

import java.util.List;
import java.util.function.Supplier;
import org.pendant.script.value.ScriptError;

/**
 * Connectors of a controller to other computers and devices. The controller starts a request,
 * continues with its frames, and looks once a frame whether the answer has come; no method here
 * waits.
 *
 * @param sockets opens TCP connections (manual 18.54 to 18.66)
 * @param rpc calls functions of other computers (manual 8, 18.40)
 * @param modbus speaks to Modbus devices (manual 18.18 to 18.31)
 * @param toolSerial what the tool's serial line leads to (manual 18.50)
 */
public record Connectors(
    SocketConnector sockets,
    RpcConnector rpc,
    ModbusConnector modbus,
    ToolSerialConnector toolSerial) {
  /** No way out: everything is refused. */
  public static final Connectors NONE =
      new Connectors(
          (host, port) -> {
            throw missing();
          },
          url -> {
            throw missing();
          },
          ModbusConnector.NONE,
          ToolSerialConnector.NONE);

  /** With nothing at the tool's serial line. */
  public Connectors(SocketConnector sockets, RpcConnector rpc, ModbusConnector modbus) {
    this(sockets, rpc, modbus, ToolSerialConnector.NONE);
  }

  /** Without a way to Modbus devices. */
  public Connectors(SocketConnector sockets, RpcConnector rpc) {
    this(sockets, rpc, ModbusConnector.NONE);
  }

  /** With something at the tool's serial line. */
  public Connectors withToolSerial(ToolSerialConnector door) {
    return new Connectors(sockets, rpc, modbus, door);
  }

  /**
   * Those that {@code now} answers whenever one is needed, so that a controller can get its ways
   * out after it was made.
   */
  public static Connectors by(Supplier<Connectors> now) {
    return new Connectors(
        (host, port) -> now.get().sockets().open(host, port),
        url -> now.get().rpc().open(url),
        new ModbusConnector() {
          @Override
          public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
            return now.get().modbus().add(exchange);
          }

          @Override
          public Pending send(ModbusAddress device, int unit, int function, byte[] data)
              throws ScriptError {
            return now.get().modbus().send(device, unit, function, data);
          }
        },
        new ToolSerialConnector() {
          @Override
          public SetUp setUp(ToolCommunication wanted) {
            return now.get().toolSerial().setUp(wanted);
          }

          @Override
          public List<News> takeNews() {
            return now.get().toolSerial().takeNews();
          }
        });
  }

  static ScriptError missing() {
    return new ScriptError("no-outside", text("noWayOut"));
  }
}
