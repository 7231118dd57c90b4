package org.pendant.protocols.net;

import java.io.IOException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.util.Optional;

/**
 * Channel readiness: lets one thread wait until a channel that does not block can be read, or
 * written.
 */
final class Readiness implements AutoCloseable {
  private final SocketChannel channel;
  private final int operation;
  private volatile Optional<Selector> selector = Optional.empty();

  /**
   * For one direction; takes nothing from the system until a thread waits.
   *
   * @param operation of {@link SelectionKey}
   */
  Readiness(SocketChannel channel, int operation) {
    this.channel = channel;
    this.operation = operation;
  }

  /**
   * Waits. Comes back after {@link #wake} as well, also one that came before.
   *
   * @throws IOException if the channel is closed, or the system gives no more
   */
  void await() throws IOException {
    if (selector.isEmpty()) {
      selector = Optional.of(Selector.open());
      channel.register(selector.get(), operation);
    }
    selector.get().select();
    selector.get().selectedKeys().clear();
  }

  /** Ends the waiting; call it when the channel was closed, which alone does not end it. */
  void wake() {
    selector.ifPresent(Selector::wakeup);
  }

  /** Gives back what it took from the system; only for the thread that waits. */
  @Override
  public void close() throws IOException {
    if (selector.isPresent()) {
      selector.get().close();
    }
  }
}
