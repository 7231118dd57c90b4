package org.pendant.controller.box;

import java.util.List;
import org.pendant.controller.io.ToolCommunication;
import org.pendant.controller.outside.Doors;
import org.pendant.controller.outside.ModbusAddress;
import org.pendant.controller.outside.ModbusDoor;
import org.pendant.controller.outside.ModbusExchange;
import org.pendant.controller.outside.ModbusPoint;
import org.pendant.controller.outside.OutsideSocket;
import org.pendant.controller.outside.Pending;
import org.pendant.controller.outside.RpcLink;
import org.pendant.controller.outside.ToolSerialDoor;
import org.pendant.controller.value.ScriptError;

/** Doors that note when somebody goes out: what comes back is never the same twice. */
final class WatchedDoors {
  private WatchedDoors() {}

  /** The same doors; a way out that is refused leaves {@code repeatability} as it is. */
  static Doors of(Doors doors, Repeatability repeatability) {
    return new Doors(
        (host, port) -> {
          OutsideSocket socket = doors.sockets().open(host, port);
          repeatability.lose("a program connected a socket to " + host + ":" + port);
          return socket;
        },
        url -> {
          RpcLink link = doors.rpc().open(url);
          repeatability.lose("a program asked for remote procedures at " + url);
          return link;
        },
        new Modbus(doors.modbus(), repeatability),
        doors.toolSerial().equals(ToolSerialDoor.NONE)
            ? ToolSerialDoor.NONE
            : new ToolSerial(doors.toolSerial(), repeatability));
  }

  private record Modbus(ModbusDoor door, Repeatability repeatability) implements ModbusDoor {
    @Override
    public ModbusPoint add(ModbusExchange exchange) throws ScriptError {
      ModbusPoint point = door.add(exchange);
      repeatability.lose("a Modbus signal was added at " + exchange.device());
      return point;
    }

    @Override
    public Pending send(ModbusAddress device, int unit, int function, byte[] data)
        throws ScriptError {
      Pending answer = door.send(device, unit, function, data);
      repeatability.lose("a program sent a Modbus request to " + device);
      return answer;
    }
  }

  private static final class ToolSerial implements ToolSerialDoor {
    private final ToolSerialDoor door;
    private final Repeatability repeatability;
    private boolean on;

    ToolSerial(ToolSerialDoor door, Repeatability repeatability) {
      this.door = door;
      this.repeatability = repeatability;
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
      repeatability.lose("a program changed the serial line of the tool");
      return setUp;
    }

    @Override
    public List<News> takeNews() {
      List<News> news = door.takeNews();
      if (!news.isEmpty()) {
        repeatability.lose("the serial line of the tool told: " + news.getFirst().text());
      }
      return news;
    }
  }
}
