package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;

/**
 * State broadcaster: passes every frame to the servers in a thread of its own, so that the frame
 * loop and the servers never wait for each other.
 */
public final class StateBroadcaster implements AutoCloseable {
  private final StateStream feed;
  private final StateStream.Subscription frames;
  private final PeerLog log;
  private final List<Listener> listeners = new CopyOnWriteArrayList<>();
  private final Thread thread;
  private volatile BooleanSupplier onTime = () -> true;

  private record Listener(Consumer<ControllerState> hears, FaultGuard guard) {}

  /** Follows {@code feed} until closed. */
  public StateBroadcaster(StateStream feed, PeerLog log) {
    this.feed = feed;
    frames = feed.follow(() -> onTime.getAsBoolean());
    this.log = log;
    thread = Thread.ofPlatform().daemon().name("frames for servers").start(this::run);
  }

  /**
   * Has {@code listener} see every frame.
   *
   * @param listener must not wait: it delays the other servers
   */
  public void add(Consumer<ControllerState> listener) {
    listeners.add(new Listener(listener, new FaultGuard(text("aServer"), log)));
  }

  /**
   * Has every frame come as soon as it is due only while somebody needs that; at first it does so
   * always.
   *
   * @param needed such as while a peer is connected
   */
  public void onTimeWhile(BooleanSupplier needed) {
    onTime = needed;
  }

  /** Says that what was handed to {@link #onTimeWhile} may have begun to hold. Any thread. */
  public void peerCame() {
    feed.followedByMore();
  }

  /** Ends {@link #add}. */
  public void remove(Consumer<ControllerState> listener) {
    listeners.removeIf(each -> each.hears().equals(listener));
  }

  private void run() {
    try {
      ControllerState state = frames.take();
      while (!frames.closed()) {
        hand(state);
        state = frames.take();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void hand(ControllerState state) {
    for (Listener each : listeners) {
      each.guard().run(() -> each.hears().accept(state));
    }
  }

  @Override
  public void close() {
    frames.close();
    thread.interrupt();
  }
}
