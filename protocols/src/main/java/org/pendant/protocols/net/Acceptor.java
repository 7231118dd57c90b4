package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.io.IOException;
import java.time.Duration;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Acceptor: takes peers from a port, one after the other, until it is closed. Where the system
 * gives no more, such as no more open files, it waits, longer each time, and says so once.
 */
final class Acceptor<P> implements Runnable {
  /** The first wait, and the longest. */
  static final Duration MIN_WAIT = Duration.ofMillis(10);

  static final Duration MAX_WAIT = Duration.ofSeconds(1);

  private final String name;
  private final Door<P> door;
  private final Waiting waiting;
  private final PeerLog log;
  private Duration wait = MIN_WAIT;
  private boolean failing;

  /** Where peers come in. */
  interface Door<P> {
    /** Whether it has not been closed. */
    boolean open();

    /** Waits for a peer. */
    P accept() throws IOException;

    /** Begins the conversation, in threads of its own. */
    void greet(P peer) throws IOException;
  }

  /** Lets time pass. */
  @FunctionalInterface
  interface Waiting {
    /** Comes back after {@code time}. */
    void await(Duration time) throws InterruptedException;
  }

  Acceptor(String name, Door<P> door, Waiting waiting, PeerLog log) {
    this.name = name;
    this.door = door;
    this.waiting = waiting;
    this.log = log;
  }

  @Override
  public void run() {
    try {
      while (door.open()) {
        takeOne();
      }
    } catch (InterruptedException e) {
      // the port was closed in the middle of a wait
      Thread.currentThread().interrupt();
    }
  }

  private void takeOne() throws InterruptedException {
    P peer;
    try {
      peer = door.accept();
    } catch (IOException | OutOfMemoryError e) {
      backOff(e);
      return;
    }
    if (failing) {
      failing = false;
      wait = MIN_WAIT;
      log.write(Level.INFO, text("connectionsAreTakenAgain", name));
    }
    greet(peer);
  }

  private void greet(P peer) {
    try {
      door.greet(peer);
    } catch (IOException | RuntimeException | OutOfMemoryError e) {
      if (door.open()) {
        log.write(Level.WARNING, text("connectionFailed", name, e.getMessage()));
      }
    }
  }

  private void backOff(Throwable trouble) throws InterruptedException {
    if (!door.open()) {
      return;
    }
    if (!failing) {
      failing = true;
      log.write(Level.WARNING, text("noConnectionCanBeTaken", name, trouble.getMessage()));
    }
    waiting.await(wait);
    wait = wait.multipliedBy(2);
    wait = wait.compareTo(MAX_WAIT) > 0 ? MAX_WAIT : wait;
  }
}
