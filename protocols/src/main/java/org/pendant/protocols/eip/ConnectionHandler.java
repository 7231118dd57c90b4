package org.pendant.protocols.eip;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.eip.AssemblyPair;

/**
 * Connection handler: opens and closes connections on request of scanners (CIP volume 1, 3-5.5).
 */
final class ConnectionHandler {
  /** Where scanners and adapters expect cyclic data. */
  static final int STANDARD_IO_PORT = 2222;

  private static final int CYCLIC = 0x01;
  private static final int MESSAGES = 0x03;
  private static final long MIN_US = 2_000;
  private static final long MAX_US = 10_000_000;

  /** A packet counts its data in two bytes; one to the robot has the 32 bits of run and idle. */
  private static final int NUMBER_BYTES = 2;

  private static final int RUN_IDLE_BYTES = 4;
  private static final int CLOSE_FIXED = 12;

  private final Connections connections;
  private final AssemblyHandler assemblyHandler;

  ConnectionHandler(Connections connections, AssemblyHandler assemblyHandler) {
    this.connections = connections;
    this.assemblyHandler = assemblyHandler;
  }

  /** Answers Forward_Open and Large_Forward_Open. */
  ByteBuffer open(CipRequest message, Exchange exchange) throws InterruptedException {
    boolean large = message.service() == CipRequest.LARGE_FORWARD_OPEN;
    Optional<OpenRequest> request = Optional.empty();
    try {
      request = Optional.of(OpenRequest.decode(message.data(), large));
      return message.answer(open(request.get(), exchange));
    } catch (CipRefusal e) {
      return message.answer(
          e,
          request
              .map(each -> each.name().encode(new LittleEndian()).u16(0).toBuffer())
              .orElseGet(Encapsulation::nothing));
    }
  }

  private ByteBuffer open(OpenRequest request, Exchange exchange)
      throws CipRefusal, InterruptedException {
    Optional<ConnectionFault> wrongDevice =
        request.path().key().flatMap(key -> key.mismatch(DeviceIdentity.OWN));
    if (wrongDevice.isPresent()) {
      throw CipRefusal.connection(wrongDevice.get());
    }
    checkIntervals(request);
    int id;
    if (request.transport() == CYCLIC) {
      id = openCyclic(request, exchange);
    } else if (request.transportClass() == MESSAGES) {
      id = openExplicit(request, exchange);
    } else {
      throw CipRefusal.connection(ConnectionFault.TRANSPORT);
    }
    return request
        .name()
        .encode(new LittleEndian().u32(id).u32(request.toOriginatorId()))
        .u32((int) request.toTargetUs())
        .u32((int) request.toOriginatorUs())
        .u16(0)
        .toBuffer();
  }

  private static void checkIntervals(OpenRequest request) throws CipRefusal {
    boolean cyclic = request.transport() == CYCLIC;
    if (request.toTargetUs() < MIN_US
        || request.toOriginatorUs() < MIN_US
        || (cyclic && Math.max(request.toTargetUs(), request.toOriginatorUs()) > MAX_US)) {
      throw CipRefusal.connection(ConnectionFault.RPI);
    }
  }

  private int openExplicit(OpenRequest request, Exchange exchange) throws CipRefusal {
    CipPath path = request.path();
    if (!path.objectClass().equals(OptionalInt.of(DeviceObjects.MESSAGE_ROUTER))
        || !path.instances().equals(List.of(1))) {
      throw CipRefusal.connection(ConnectionFault.PATH);
    }
    return connections.openExplicit(request, exchange.session());
  }

  private int openCyclic(OpenRequest request, Exchange exchange)
      throws CipRefusal, InterruptedException {
    CipPath path = request.path();
    if (!path.objectClass().equals(OptionalInt.of(DeviceObjects.ASSEMBLY))
        || path.instances().size() != 3) {
      throw CipRefusal.connection(ConnectionFault.PATH);
    }
    if (path.dataBytes() > 0) {
      throw CipRefusal.connection(ConnectionFault.CONFIGURATION_SIZE, 0);
    }
    int fromScanner = path.instances().get(1);
    int toScanner = path.instances().get(2);
    OptionalInt fromBytes = assemblyHandler.fromScannerBytes(fromScanner);
    OptionalInt toBytes = assemblyHandler.toScannerBytes(toScanner);
    if (path.instances().getFirst() != AssemblyPair.CONFIGURATION
        || fromBytes.isEmpty()
        || toBytes.isEmpty()) {
      throw CipRefusal.connection(ConnectionFault.PATH);
    }
    check(
        request.toTarget(),
        NUMBER_BYTES + RUN_IDLE_BYTES + fromBytes.getAsInt(),
        ConnectionFault.VARIABLE_SIZE_TO_TARGET,
        ConnectionFault.SIZE_TO_TARGET);
    check(
        request.toOriginator(),
        NUMBER_BYTES + toBytes.getAsInt(),
        ConnectionFault.VARIABLE_SIZE_TO_ORIGINATOR,
        ConnectionFault.SIZE_TO_ORIGINATOR);
    CyclicConnection opened =
        connections.openCyclic(request, scanner(exchange), fromScanner, toScanner);
    if (connections.ioPort() != STANDARD_IO_PORT) {
      exchange.add(
          new PacketItem(
              PacketItem.SOCKET_TO_TARGET,
              new LittleEndian()
                  .bytes(
                      Encapsulation.socket(new InetSocketAddress("0.0.0.0", connections.ioPort())))
                  .toBuffer()));
    }
    return opened.id();
  }

  private static void check(
      ConnectionParameters wanted, int bytes, ConnectionFault variable, ConnectionFault size)
      throws CipRefusal {
    if (wanted.type() != ConnectionParameters.Type.POINT_TO_POINT) {
      throw CipRefusal.connection(ConnectionFault.TYPE);
    }
    if (wanted.variable()) {
      throw CipRefusal.connection(variable);
    }
    if (wanted.bytes() != bytes) {
      throw CipRefusal.connection(size, bytes);
    }
  }

  /** Packets go to the computer that asked and no other, at the port that it may have chosen. */
  private static InetSocketAddress scanner(Exchange exchange) {
    int port =
        PacketItem.first(exchange.sent(), PacketItem.SOCKET_TO_ORIGINATOR)
            .map(PacketItem::data)
            .filter(data -> data.remaining() >= 4)
            .map(data -> data.duplicate().order(ByteOrder.BIG_ENDIAN))
            .map(data -> Short.toUnsignedInt(data.getShort(2)))
            .filter(chosen -> chosen > 0)
            .orElse(STANDARD_IO_PORT);
    return new InetSocketAddress(exchange.peer().getAddress(), port);
  }

  /** Answers Forward_Close. */
  ByteBuffer close(CipRequest message, Exchange exchange) throws InterruptedException {
    ByteBuffer in = message.data().slice().order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < CLOSE_FIXED) {
      return message.answer(new CipRefusal(CipRefusal.TOO_SHORT), Encapsulation.nothing());
    }
    // how long the request itself may take
    in.position(2);
    ConnectionName name = ConnectionName.decode(in);
    ByteBuffer result = name.encode(new LittleEndian()).u16(0).toBuffer();
    try {
      connections.close(name, exchange.peer().getAddress());
      return message.answer(result);
    } catch (CipRefusal e) {
      return message.answer(e, result);
    }
  }
}
