package org.pendant.controller.box;

import static org.pendant.controller.box.BoxTexts.text;

import java.util.List;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusConnector;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusPoint;
import org.pendant.controller.external.Pending;
import org.pendant.controller.external.RpcLink;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.script.value.ScriptError;

/**
 * Determinism guard: connectors that mark the run as not reproducible as soon as one of them is
 * used.
 */
final class DeterminismGuard {
  private DeterminismGuard() {}

  /** The same doors; a way out that is refused leaves {@code repeatability} as it is. */
  static Connectors of(Connectors connectors, Determinism determinism) {
    return new Connectors(
        (host, port) -> {
          ExternalSocket socket = connectors.sockets().open(host, port);
          determinism.taint(text("socketConnected", host, port));
          return socket;
        },
        url -> {
          RpcLink link = connectors.rpc().open(url);
          determinism.taint(text("rpcAsked", url));
          return link;
        },
        new Modbus(connectors.modbus(), determinism),
        connectors.toolSerial().equals(ToolSerialConnector.NONE)
            ? ToolSerialConnector.NONE
            : new ToolSerial(connectors.toolSerial(), determinism));
  }

  private record Modbus(ModbusConnector door, Determinism determinism) implements ModbusConnector {
    @Override
    public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
      ModbusPoint point = door.add(exchange);
      determinism.taint(text("modbusAdded", exchange.device()));
      return point;
    }

    @Override
    public Pending send(ModbusAddress device, int unit, int function, byte[] data)
        throws ScriptError {
      Pending answer = door.send(device, unit, function, data);
      determinism.taint(text("modbusSent", device));
      return answer;
    }
  }

  private static final class ToolSerial implements ToolSerialConnector {
    private final ToolSerialConnector door;
    private final Determinism determinism;
    private boolean on;

    ToolSerial(ToolSerialConnector door, Determinism determinism) {
      this.door = door;
      this.determinism = determinism;
    }

    @Override
    public SetUp setUp(ToolCommunication wanted) {
      boolean staysOff = !on && !wanted.enabled();
      on = wanted.enabled();
      SetUp setUp = door.setUp(wanted);
      if (staysOff) {
        // programs begin like this; nothing happens outside that they would have to wait for
        return () -> true;
      }
      determinism.taint(text("serialLineChanged"));
      return setUp;
    }

    @Override
    public List<News> takeNews() {
      List<News> news = door.takeNews();
      if (!news.isEmpty()) {
        determinism.taint(text("serialLineTold", news.getFirst().text()));
      }
      return news;
    }
  }
}
