package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Peer log: the controller's log as servers use it: at most {@link #PER_SECOND} lines a second, so
 * that a hostile peer cannot push everything else out. Any thread.
 */
public final class PeerLog {
  /** Lines that are written in a second; of more only the number. */
  public static final int PER_SECOND = 10;

  private static final long SECOND_NS = 1_000_000_000L;

  private final BiConsumer<Level, String> log;
  private final LongSupplier nanoTime;
  private final Optional<PeerLog> visits;
  private final AtomicLong leftOut = new AtomicLong();
  private long secondBeganNs;
  private int written;

  /** Writes to {@code log}, which must not wait. */
  public PeerLog(BiConsumer<Level, String> log) {
    this(log, Optional.empty(), System::nanoTime);
  }

  /** As {@link #PeerLog(BiConsumer)}; who comes and leaves is told apart, as often at most. */
  public PeerLog(BiConsumer<Level, String> log, Consumer<String> visits) {
    this(log, Optional.of(new PeerLog((level, text) -> visits.accept(text))), System::nanoTime);
  }

  PeerLog(BiConsumer<Level, String> log, Optional<PeerLog> visits, LongSupplier nanoTime) {
    this.log = log;
    this.visits = visits;
    this.nanoTime = nanoTime;
    secondBeganNs = nanoTime.getAsLong();
  }

  /** Tells that a peer has come or left, where somebody wants to know. */
  void visit(String text) {
    visits.ifPresent(each -> each.write(Level.INFO, text));
  }

  /** Writes a line, or counts it where there are too many. */
  public synchronized void write(Level level, String text) {
    long nowNs = nanoTime.getAsLong();
    if (nowNs - secondBeganNs >= SECOND_NS) {
      secondBeganNs = nowNs;
      written = 0;
      long more = leftOut.getAndSet(0);
      if (more > 0) {
        log.accept(Level.WARNING, text("messagesLeftOut", more));
      }
    }
    if (written < PER_SECOND) {
      written++;
      log.accept(level, text);
    } else {
      leftOut.incrementAndGet();
    }
  }
}
