package org.pendant.protocols.eip;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import java.util.Optional;

/** Message router: takes explicit messages to the objects that they are for. */
final class MessageRouter {
  private static final int REVISION = 1;
  private static final int MAX_INSTANCE = 2;

  /** What stands in front of a message within another one: two times and its length. */
  private static final int EMBEDDING = 4;

  private final Map<Integer, CipObject> objects;
  private final ConnectionHandler manager;

  /**
   * A router.
   *
   * @param objects by the numbers of their classes
   */
  MessageRouter(Map<Integer, CipObject> objects, ConnectionHandler manager) {
    this.objects = Map.copyOf(objects);
    this.manager = manager;
  }

  /** Carries a message out; answers what is sent back. */
  ByteBuffer answer(ByteBuffer message, Exchange exchange) throws InterruptedException {
    return answer(message, exchange, false);
  }

  private ByteBuffer answer(ByteBuffer message, Exchange exchange, boolean embedded)
      throws InterruptedException {
    try {
      CipRequest request = CipRequest.decode(message);
      return answer(request, exchange, embedded);
    } catch (CipRefusal e) {
      int service = message.hasRemaining() ? Byte.toUnsignedInt(message.get(0)) : 0;
      return CipRequest.refused(service, e, Encapsulation.nothing());
    }
  }

  private ByteBuffer answer(CipRequest request, Exchange exchange, boolean embedded)
      throws CipRefusal, InterruptedException {
    CipPath path = CipPath.decode(request.path());
    int number = path.objectClass().orElseThrow(() -> new CipRefusal(CipRefusal.UNKNOWN_PATH));
    if (number == DeviceObjects.CONNECTION_MANAGER) {
      return switch (request.service()) {
        case CipRequest.FORWARD_OPEN, CipRequest.LARGE_FORWARD_OPEN ->
            manager.open(request, exchange);
        case CipRequest.FORWARD_CLOSE -> manager.close(request, exchange);
        case CipRequest.UNCONNECTED_SEND -> {
          if (embedded) {
            throw new CipRefusal(CipRefusal.UNKNOWN_SERVICE);
          }
          yield answer(embedded(request.data()), exchange, true);
        }
        default -> throw new CipRefusal(CipRefusal.UNKNOWN_SERVICE);
      };
    }
    CipObject object = objects.get(number);
    if (object == null) {
      throw new CipRefusal(CipRefusal.UNKNOWN_PATH);
    }
    return request.answer(serve(object, request, path));
  }

  /** The message in an Unconnected_Send; its route is not looked at, as it can only end here. */
  private static ByteBuffer embedded(ByteBuffer data) throws CipRefusal {
    ByteBuffer in = data.slice().order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < EMBEDDING) {
      throw new CipRefusal(CipRefusal.TOO_SHORT);
    }
    int length = Short.toUnsignedInt(in.getShort(2));
    if (in.remaining() < EMBEDDING + length) {
      throw new CipRefusal(CipRefusal.TOO_SHORT);
    }
    return in.slice(EMBEDDING, length).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static ByteBuffer serve(CipObject object, CipRequest request, CipPath path)
      throws CipRefusal {
    int instance = path.instances().isEmpty() ? 0 : path.instances().getFirst();
    if (instance != 0 && !object.has(instance)) {
      throw new CipRefusal(CipRefusal.UNKNOWN_OBJECT);
    }
    return switch (request.service()) {
      case CipRequest.GET_ATTRIBUTE -> attribute(object, instance, path);
      case CipRequest.SET_ATTRIBUTE -> {
        attribute(object, instance, path);
        throw new CipRefusal(CipRefusal.NOT_SETTABLE);
      }
      case CipRequest.GET_ALL ->
          Optional.of(instance)
              .filter(number -> number != 0)
              .flatMap(object::all)
              .orElseThrow(() -> new CipRefusal(CipRefusal.UNKNOWN_SERVICE));
      default -> throw new CipRefusal(CipRefusal.UNKNOWN_SERVICE);
    };
  }

  private static ByteBuffer attribute(CipObject object, int instance, CipPath path)
      throws CipRefusal {
    int number = path.attribute().orElse(0);
    Optional<ByteBuffer> found =
        instance == 0 ? ofClass(object, number) : object.attribute(instance, number);
    return found.orElseThrow(() -> new CipRefusal(CipRefusal.UNKNOWN_ATTRIBUTE));
  }

  private static Optional<ByteBuffer> ofClass(CipObject object, int attribute) {
    return switch (attribute) {
      case REVISION -> Optional.of(new LittleEndian().u16(object.revision()).toBuffer());
      case MAX_INSTANCE -> Optional.of(new LittleEndian().u16(object.highestInstance()).toBuffer());
      default -> Optional.empty();
    };
  }
}
