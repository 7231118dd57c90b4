package org.pendant.protocols.eip;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.net.ProtocolException;
import org.pendant.protocols.net.Session;

/** EtherNet/IP session: the messages of one client. Requests are answered in their order. */
final class EipSession implements Session {
  /** Interface handle and timeout in front of the items. */
  private static final int ITEMS_AT = 6;

  private static final int REGISTER_BYTES = 4;

  private final Connection connection;
  private final int number;
  private final MessageRouter router;
  private final Connections connections;
  private final Supplier<ByteBuffer> identity;
  private final EncapsulationReader cutter = new EncapsulationReader();
  private boolean registered;

  /**
   * A client that has just connected.
   *
   * @param number that its session gets
   * @param identity what ListIdentity tells
   */
  EipSession(
      Connection connection,
      int number,
      MessageRouter router,
      Connections connections,
      Supplier<ByteBuffer> identity) {
    this.connection = connection;
    this.number = number;
    this.router = router;
    this.connections = connections;
    this.identity = identity;
  }

  @Override
  public void received(ByteBuffer bytes) throws ProtocolException {
    try {
      for (Optional<EncapsulationFrame> frame = cutter.next(bytes);
          frame.isPresent();
          frame = cutter.next(bytes)) {
        answer(frame.get());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Override
  public void closed() {
    connections.sessionEnded(number);
  }

  private void answer(EncapsulationFrame frame) throws InterruptedException {
    if (!frame.isRequest()) {
      return;
    }
    switch (frame.command()) {
      case Encapsulation.NOP -> {}
      case Encapsulation.LIST_SERVICES -> send(frame, Encapsulation.services());
      case Encapsulation.LIST_IDENTITY -> send(frame, identity.get());
      case Encapsulation.LIST_INTERFACES -> send(frame, Encapsulation.items());
      case Encapsulation.REGISTER_SESSION -> register(frame);
      case Encapsulation.UNREGISTER_SESSION -> connection.closeAfterSending();
      case Encapsulation.SEND_RR_DATA -> unconnected(frame);
      case Encapsulation.SEND_UNIT_DATA -> connected(frame);
      default -> refuse(frame, Encapsulation.UNKNOWN_COMMAND);
    }
  }

  private void send(EncapsulationFrame frame, ByteBuffer data) {
    connection.send(frame.answer(Encapsulation.SUCCESS, data).encode());
  }

  private void refuse(EncapsulationFrame frame, int status) {
    connection.send(frame.answer(status, Encapsulation.nothing()).encode());
  }

  private void register(EncapsulationFrame frame) {
    if (frame.data().remaining() != REGISTER_BYTES) {
      refuse(frame, Encapsulation.BAD_LENGTH);
    } else if (frame.data().getShort(0) != Encapsulation.VERSION || frame.data().getShort(2) != 0) {
      refuse(frame, Encapsulation.BAD_VERSION);
    } else if (registered) {
      refuse(frame, Encapsulation.UNKNOWN_COMMAND);
    } else {
      registered = true;
      send(frame.ofSession(number), frame.data());
    }
  }

  /** The items of a message; when there is something wrong with them, that is answered. */
  private Optional<List<PacketItem>> items(EncapsulationFrame frame) {
    if (!registered || frame.session() != number) {
      refuse(frame, Encapsulation.BAD_SESSION);
      return Optional.empty();
    }
    ByteBuffer data = frame.data();
    Optional<List<PacketItem>> items =
        data.remaining() < ITEMS_AT || data.getInt(0) != 0
            ? Optional.empty()
            : PacketItem.decode(data.slice(ITEMS_AT, data.remaining() - ITEMS_AT));
    if (items.isEmpty()) {
      refuse(frame, Encapsulation.BAD_DATA);
    }
    return items;
  }

  private void unconnected(EncapsulationFrame frame) throws InterruptedException {
    Optional<List<PacketItem>> items = items(frame);
    if (items.isEmpty()) {
      return;
    }
    Optional<PacketItem> message = PacketItem.first(items.get(), PacketItem.UNCONNECTED_DATA);
    if (message.isEmpty()) {
      refuse(frame, Encapsulation.BAD_DATA);
      return;
    }
    Exchange exchange = new Exchange(connection.peer(), number, items.get());
    ByteBuffer answer = router.answer(message.get().data(), exchange);
    LittleEndian out = new LittleEndian().u32(0).u16(0);
    List<PacketItem> answered =
        new ArrayList<>(
            List.of(
                new PacketItem(PacketItem.NO_ADDRESS, Encapsulation.nothing()),
                new PacketItem(PacketItem.UNCONNECTED_DATA, answer)));
    answered.addAll(exchange.added());
    send(frame, PacketItem.encode(out, answered).toBuffer());
  }

  private void connected(EncapsulationFrame frame) throws InterruptedException {
    Optional<List<PacketItem>> items = items(frame);
    if (items.isEmpty()) {
      return;
    }
    Optional<PacketItem> address =
        PacketItem.first(items.get(), PacketItem.CONNECTED_ADDRESS)
            .filter(item -> item.data().remaining() == 4);
    Optional<PacketItem> data =
        PacketItem.first(items.get(), PacketItem.CONNECTED_DATA)
            .filter(item -> item.data().remaining() >= 2);
    if (address.isEmpty() || data.isEmpty()) {
      refuse(frame, Encapsulation.BAD_DATA);
      return;
    }
    Optional<ExplicitConnection> by = connections.explicit(address.get().data().getInt(0), number);
    if (by.isPresent()) {
      connected(frame, by.get(), data.get().data(), items.get());
    }
    // nothing is answered by a connection that does not exist: the client times out
  }

  private void connected(
      EncapsulationFrame frame, ExplicitConnection by, ByteBuffer data, List<PacketItem> items)
      throws InterruptedException {
    InetSocketAddress peer = connection.peer();
    ByteBuffer message = data.slice(2, data.remaining() - 2).order(ByteOrder.LITTLE_ENDIAN);
    ByteBuffer answer = router.answer(message, new Exchange(peer, number, items));
    if (answer.remaining() + 2 > by.request().toOriginator().bytes()) {
      answer =
          CipRequest.refused(
              Byte.toUnsignedInt(answer.get(0)) & ~CipRequest.ANSWER,
              new CipRefusal(CipRefusal.REPLY_TOO_LARGE),
              Encapsulation.nothing());
    }
    ByteBuffer numbered =
        new LittleEndian().u16(Short.toUnsignedInt(data.getShort(0))).bytes(answer).toBuffer();
    ByteBuffer address = new LittleEndian().u32(by.request().toOriginatorId()).toBuffer();
    LittleEndian out = new LittleEndian().u32(0).u16(0);
    send(
        frame,
        PacketItem.encode(
                out,
                List.of(
                    new PacketItem(PacketItem.CONNECTED_ADDRESS, address),
                    new PacketItem(PacketItem.CONNECTED_DATA, numbered)))
            .toBuffer());
  }
}
