package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.protocols.wire.Direction;
import org.pendant.protocols.wire.Dissector;
import org.pendant.protocols.wire.Fields;
import org.pendant.protocols.wire.Reading;

/** EtherNet/IP dissector: the encapsulation layer, and the service that a message asks for. */
final class EipDissector implements Dissector {
  private static final int LENGTH_AT = 2;
  private static final int ITEMS_AT = 6;

  @Override
  public int length(Direction direction, ByteBuffer bytes) {
    if (bytes.remaining() < LENGTH_AT + Short.BYTES) {
      return MORE;
    }
    ByteBuffer little = bytes.slice().order(ByteOrder.LITTLE_ENDIAN);
    return EncapsulationFrame.HEADER + Short.toUnsignedInt(little.getShort(LENGTH_AT));
  }

  @Override
  public Reading read(Direction direction, ByteBuffer message) {
    EncapsulationFrame frame = EncapsulationFrame.decode(message);
    String type = name(frame.command());
    Optional<Integer> service = service(frame);
    boolean asked = direction == Direction.IN;
    String said = service.map(each -> said(type, each)).orElse(type);
    String summary = frame.status() == 0 ? said : text("withStatus", said, frame.status());
    Reading reading =
        Reading.of(
            type,
            summary,
            () -> {
              Map<String, Object> fields =
                  Fields.of("session", frame.session(), "status", frame.status());
              service.ifPresent(each -> fields.put("service", each));
              return fields;
            });
    return asked && service.equals(Optional.of(CipRequest.SET_ATTRIBUTE))
        ? reading.doing(text("setsAnAttribute"))
        : reading;
  }

  private static String name(int command) {
    return switch (command) {
      case Encapsulation.NOP -> "nop";
      case Encapsulation.LIST_SERVICES -> "list-services";
      case Encapsulation.LIST_IDENTITY -> "list-identity";
      case Encapsulation.LIST_INTERFACES -> "list-interfaces";
      case Encapsulation.REGISTER_SESSION -> "register-session";
      case Encapsulation.UNREGISTER_SESSION -> "unregister-session";
      case Encapsulation.SEND_RR_DATA -> "send-rr-data";
      case Encapsulation.SEND_UNIT_DATA -> "send-unit-data";
      default -> "command-" + command;
    };
  }

  private static Optional<Integer> service(EncapsulationFrame frame) {
    boolean unit = frame.command() == Encapsulation.SEND_UNIT_DATA;
    ByteBuffer data = frame.data();
    if ((!unit && frame.command() != Encapsulation.SEND_RR_DATA) || data.remaining() < ITEMS_AT) {
      return Optional.empty();
    }
    List<PacketItem> items =
        PacketItem.decode(data.slice(ITEMS_AT, data.remaining() - ITEMS_AT)).orElse(List.of());
    int at = unit ? Short.BYTES : 0;
    return PacketItem.first(items, unit ? PacketItem.CONNECTED_DATA : PacketItem.UNCONNECTED_DATA)
        .filter(item -> item.data().remaining() > at)
        .map(item -> Byte.toUnsignedInt(item.data().get(at)));
  }

  /** A message with a service of CIP, which has the name that the specification gives it. */
  private static String said(String type, int service) {
    int asked = service & ~CipRequest.ANSWER;
    String name =
        switch (asked) {
          case CipRequest.GET_ALL -> "get all attributes";
          case CipRequest.GET_ATTRIBUTE -> "get attribute";
          case CipRequest.SET_ATTRIBUTE -> "set attribute";
          case CipRequest.FORWARD_CLOSE -> "forward close";
          case CipRequest.UNCONNECTED_SEND -> "unconnected send";
          case CipRequest.FORWARD_OPEN -> "forward open";
          case CipRequest.LARGE_FORWARD_OPEN -> "large forward open";
          default -> "service " + asked;
        };
    return service == asked ? type + ", " + name : text("answerTo", type, name);
  }
}
