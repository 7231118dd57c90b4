package org.pendant.protocols.trace;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Instant;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import org.pendant.protocols.net.WireEnd;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.trace.WireEvent.Kind;

/**
 * Wire trace: hands what goes over connections to a sink, in a thread of its own. Connections do
 * not wait for it: what finds no room is left out and counted.
 */
public final class WireTrace implements WireTap, AutoCloseable {
  /** Most bytes that wait for the sink. */
  static final long MAX_WAITING_BYTES = 32L << 20;

  /** What an event takes beside its bytes. */
  private static final int EVENT_BYTES = 200;

  /** What was written is flushed so often. */
  private static final long FLUSH_MS = 100;

  private static final int BATCH = 1024;
  private static final long PATIENCE_MS = 5_000;

  private final DoubleSupplier robotTimeS;
  private final InstantSource clock;
  private final TraceSink sink;
  private final Consumer<String> trouble;
  private final BlockingQueue<WireEvent> waiting = new LinkedBlockingQueue<>();
  private final AtomicLong waitingBytes = new AtomicLong();
  private final AtomicLong leftOut = new AtomicLong();
  private final AtomicLong leftOutInAll = new AtomicLong();
  private final Thread thread;
  private volatile boolean closed;

  /**
   * Traces to {@code sink}, and closes it at the end.
   *
   * @param robotTimeS robot time, s; any thread, must not wait
   * @param trouble is told why the sink has failed, after which nothing is traced any more
   */
  WireTrace(
      DoubleSupplier robotTimeS, InstantSource clock, TraceSink sink, Consumer<String> trouble) {
    this.robotTimeS = robotTimeS;
    this.clock = clock;
    this.sink = sink;
    this.trouble = trouble;
    thread = Thread.ofPlatform().daemon().name("wire trace").unstarted(this::run);
  }

  /** Begins to hand on what is traced. */
  WireTrace start() {
    thread.start();
    return this;
  }

  @Override
  public void opened(WireEnd connection) {
    add(Kind.OPENED, connection, 0, ByteBuffer.allocate(0));
  }

  @Override
  public void received(WireEnd connection, long before, ByteBuffer bytes) {
    if (hasRoom()) {
      ByteBuffer copy = ByteBuffer.allocate(bytes.remaining()).put(bytes.duplicate()).flip();
      add(Kind.RECEIVED, connection, before, copy);
    } else {
      leaveOut();
    }
  }

  @Override
  public void sent(WireEnd connection, long before, byte[] bytes) {
    add(Kind.SENT, connection, before, ByteBuffer.wrap(bytes));
  }

  @Override
  public void closed(WireEnd connection) {
    add(Kind.CLOSED, connection, 0, ByteBuffer.allocate(0));
  }

  private boolean hasRoom() {
    return !closed && waitingBytes.get() < MAX_WAITING_BYTES;
  }

  private void leaveOut() {
    if (!closed) {
      leftOut.incrementAndGet();
      leftOutInAll.incrementAndGet();
    }
  }

  private void add(Kind kind, WireEnd connection, long before, ByteBuffer bytes) {
    if (!hasRoom()) {
      leaveOut();
      return;
    }
    waitingBytes.addAndGet(EVENT_BYTES + bytes.remaining());
    double timeS = robotTimeS.getAsDouble();
    waiting.add(new WireEvent(kind, connection, before, bytes.asReadOnlyBuffer(), nowUs(), timeS));
  }

  private long nowUs() {
    return ChronoUnit.MICROS.between(Instant.EPOCH, clock.instant());
  }

  /** How many messages or pieces of them found no room so far. */
  public long leftOut() {
    return leftOutInAll.get();
  }

  private void run() {
    try (sink) {
      List<WireEvent> batch = new ArrayList<>();
      long flushedNs = System.nanoTime();
      while (!closed || !waiting.isEmpty()) {
        WireEvent next = waiting.poll(FLUSH_MS, TimeUnit.MILLISECONDS);
        if (next != null) {
          batch.add(next);
          waiting.drainTo(batch, BATCH);
          hand(batch);
        }
        tellLeftOut();
        if (System.nanoTime() - flushedNs > TimeUnit.MILLISECONDS.toNanos(FLUSH_MS)) {
          sink.flush();
          flushedNs = System.nanoTime();
        }
      }
      sink.flush();
    } catch (IOException e) {
      closed = true;
      trouble.accept(String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      closed = true;
      waiting.clear();
    }
  }

  private void hand(List<WireEvent> batch) throws IOException {
    for (WireEvent event : batch) {
      sink.take(event);
      waitingBytes.addAndGet(-EVENT_BYTES - event.bytes().remaining());
    }
    batch.clear();
  }

  private void tellLeftOut() throws IOException {
    long count = leftOut.getAndSet(0);
    if (count > 0) {
      sink.leftOut(count, nowUs());
    }
  }

  /** Ends the trace; waits until what was traced is with the sink. */
  @Override
  public void close() {
    closed = true;
    try {
      thread.join(PATIENCE_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
