package org.pendant.protocols.toolserial;

import static org.pendant.protocols.toolserial.ToolSerialTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolSerialConnector;

/**
 * Tool serial line of one tool connector. It is a bus, as RS-485 is: what one on it sends, all
 * others hear. On it are those who {@link #join}, and a serial device where there is one. While
 * programs have turned it off, what is sent is lost.
 *
 * <p>A thread of its own does everything with the device, in the order in which it was asked for.
 */
public final class ToolSerialLine implements ToolSerialConnector, AutoCloseable {
  /** Bytes that wait for the device before senders have to wait. */
  private static final int MAX_WAITING = 1 << 16;

  /** How often a device is looked for that was there or should be, ms. */
  private static final long RETRY_MS = 1000;

  private final ReentrantLock lock = new ReentrantLock();
  private final Condition changed = lock.newCondition();
  private final Condition room = lock.newCondition();
  private final Queue<Message> waiting = new ArrayDeque<>();
  private final Queue<News> news = new ConcurrentLinkedQueue<>();
  private final List<Consumer<byte[]>> listeners = new CopyOnWriteArrayList<>();
  private final Thread thread;
  private final DeviceLine device;
  private ToolCommunication wanted = ToolCommunication.STANDARD;
  private ToolCommunication current = ToolCommunication.STANDARD;
  private long asked;
  private volatile long done;
  private int waitingBytes;
  private boolean lossTold;
  private boolean closing;

  /** Something that is sent. */
  private static final class Message {
    private final Consumer<byte[]> from;
    private final byte[] bytes;

    /** How many changes of the line come before it. */
    private final long after;

    Message(Consumer<byte[]> from, byte[] bytes, long after) {
      this.from = from;
      this.bytes = bytes;
      this.after = after;
    }
  }

  /** A line without a device. */
  public ToolSerialLine() {
    this(Optional.<SerialDevice.Opening>empty());
  }

  /**
   * A line that leads to a device, which is opened when a program turns the line on.
   *
   * @param name such as {@code /dev/ttyUSB0} or {@code COM3}
   */
  public static ToolSerialLine to(String name) {
    return new ToolSerialLine(Optional.of(() -> ComPort.open(name)));
  }

  ToolSerialLine(Optional<SerialDevice.Opening> opening) {
    device = new DeviceLine(opening, this::fromDevice, this::wake, this::tell);
    thread = Thread.ofPlatform().daemon().name("tool serial line").start(this::run);
  }

  @Override
  public SetUp setUp(ToolCommunication line) {
    lock.lock();
    try {
      wanted = line;
      asked++;
      changed.signalAll();
      long number = asked;
      return () -> done >= number;
    } finally {
      lock.unlock();
    }
  }

  @Override
  public List<News> takeNews() {
    if (news.isEmpty()) {
      return List.of();
    }
    List<News> taken = new ArrayList<>();
    for (News each = news.poll(); each != null; each = news.poll()) {
      taken.add(each);
    }
    return taken;
  }

  /** {@code listener} hears what others send from now on; it must not wait. */
  void join(Consumer<byte[]> listener) {
    listeners.add(listener);
  }

  /** {@code listener} hears nothing more. */
  void leave(Consumer<byte[]> listener) {
    listeners.remove(listener);
  }

  /** Sends something; waits while too much waits for the device. */
  void send(Consumer<byte[]> from, byte[] bytes) {
    lock.lock();
    try {
      while (waitingBytes >= MAX_WAITING && !closing) {
        room.await();
      }
      waiting.add(new Message(from, bytes, asked));
      waitingBytes += bytes.length;
      changed.signalAll();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      lock.unlock();
    }
  }

  private void fromDevice(byte[] bytes) {
    listeners.forEach(each -> each.accept(bytes));
  }

  private void wake() {
    lock.lock();
    try {
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private void tell(boolean trouble, String text) {
    news.add(new News(trouble, text("toolCommunication", text)));
  }

  private void run() {
    try {
      for (Runnable next = next(); !closing(); next = next()) {
        next.run();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      device.close();
    }
  }

  private boolean closing() {
    lock.lock();
    try {
      return closing;
    } finally {
      lock.unlock();
    }
  }

  /** Waits for something to do. */
  private Runnable next() throws InterruptedException {
    lock.lock();
    try {
      boolean retry = false;
      while (true) {
        Message head = waiting.peek();
        if (closing) {
          return () -> {};
        } else if (head != null && head.after <= done) {
          waiting.remove();
          waitingBytes -= head.bytes.length;
          room.signalAll();
          return () -> carry(head);
        } else if (asked != done) {
          ToolCommunication line = wanted;
          long number = asked;
          return () -> change(line, number);
        } else if (device.lost() || retry) {
          return device::tryAgain;
        } else if (device.missing()) {
          retry = !changed.await(RETRY_MS, TimeUnit.MILLISECONDS);
        } else {
          changed.await();
        }
      }
    } finally {
      lock.unlock();
    }
  }

  private void change(ToolCommunication line, long number) {
    current = line;
    lossTold = false;
    device.setUp(line);
    done = number;
  }

  private void carry(Message message) {
    if (!current.enabled()) {
      if (!lossTold) {
        lossTold = true;
        tell(true, text("offSoLost"));
      }
      return;
    }
    for (Consumer<byte[]> each : listeners) {
      if (!each.equals(message.from)) {
        each.accept(message.bytes);
      }
    }
    device.write(message.bytes);
  }

  /** Closes the device. */
  @Override
  public void close() {
    lock.lock();
    try {
      closing = true;
      changed.signalAll();
      room.signalAll();
    } finally {
      lock.unlock();
    }
    // a device that takes nothing holds its writer until it is closed
    device.interrupt();
    try {
      thread.join(RETRY_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
