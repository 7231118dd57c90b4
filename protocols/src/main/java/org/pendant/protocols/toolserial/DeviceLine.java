package org.pendant.protocols.toolserial;

import static org.pendant.protocols.toolserial.ToolSerialTexts.text;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.pendant.controller.external.ToolCommunication;

/**
 * Device line: the serial device of a line, present or not. One thread works it; {@link #interrupt}
 * is for others.
 */
final class DeviceLine {
  private static final double NS_PER_S = 1e9;

  /** Gets what is to be logged. */
  @FunctionalInterface
  interface Log {
    void tell(boolean trouble, String text);
  }

  private final Optional<SerialDevice.Opening> opening;
  private final Consumer<byte[]> messages;
  private final Runnable wake;
  private final Log log;
  private ToolCommunication line = ToolCommunication.STANDARD;
  private volatile Optional<Open> open = Optional.empty();
  private volatile boolean gone;
  private String told = "";
  private long busyUntilNs = System.nanoTime();

  private record Open(SerialDevice device, Hearing hearing) {}

  /**
   * Not open yet.
   *
   * @param messages gets what comes from the device
   * @param wake is called when the device has gone
   */
  DeviceLine(
      Optional<SerialDevice.Opening> opening, Consumer<byte[]> messages, Runnable wake, Log log) {
    this.opening = opening;
    this.messages = messages;
    this.wake = wake;
    this.log = log;
  }

  /** Whether it was open and has gone since. */
  boolean lost() {
    return gone;
  }

  /** Whether it should be open and is not. */
  boolean missing() {
    return line.enabled() && opening.isPresent() && open.isEmpty();
  }

  /** Opens or closes it and gives it its speed; what fails is logged. */
  void setUp(ToolCommunication wanted) {
    line = wanted;
    told = "";
    if (!wanted.enabled()) {
      close();
    } else if (open.isPresent()) {
      apply(open.get());
    } else if (missing()) {
      open();
    }
  }

  /** Has another look at a device that is gone or was not there. */
  void tryAgain() {
    if (gone) {
      close();
      complain(text("deviceGone"));
    }
    if (missing() && open()) {
      log.tell(false, text("deviceThereNow"));
      told = "";
    }
  }

  private boolean open() {
    try {
      SerialDevice device = opening.orElseThrow().open();
      Open opened = new Open(device, Hearing.of(device, messages, this::lose));
      open = Optional.of(opened);
      apply(opened);
      return true;
    } catch (IOException e) {
      complain(e.getMessage());
      return false;
    }
  }

  private void apply(Open opened) {
    opened.hearing().setUp(line);
    if (!opened.device().setUp(line)) {
      complain(text("cannotDoBaudRate", line.baudRate()));
    }
  }

  /** Every look at a device that is not there would say the same. */
  private void complain(String text) {
    if (!told.equals(text)) {
      told = text;
      log.tell(true, text);
    }
  }

  private void lose() {
    gone = true;
    wake.run();
  }

  /** Writes to the device, if it is there, after the silence that the line asks for. */
  void write(byte[] bytes) {
    if (open.isEmpty()) {
      return;
    }
    Open now = open.get();
    long silenceNs = lengthNs(line.txIdleChars());
    long quietNs = Math.max(busyUntilNs - System.nanoTime(), lastHeardNs(now)) + silenceNs;
    while (quietNs > 0 && !now.hearing().over()) {
      LockSupport.parkNanos(this, quietNs);
      quietNs = Math.max(busyUntilNs - System.nanoTime(), lastHeardNs(now)) + silenceNs;
    }
    if (!now.device().write(bytes)) {
      complain(text("notTaken", bytes.length));
    }
    busyUntilNs = System.nanoTime() + lengthNs(bytes.length);
  }

  /** When the device was heard last, against now; negative. */
  private static long lastHeardNs(Open now) {
    return now.hearing().lastNs() - System.nanoTime();
  }

  private long lengthNs(double characters) {
    return (long) (line.lengthS(characters) * NS_PER_S);
  }

  /** Closes it, whatever its own thread does just now. */
  void interrupt() {
    open.ifPresent(
        each -> {
          each.hearing().end();
          each.device().close();
        });
  }

  /** Closes it. */
  void close() {
    interrupt();
    open = Optional.empty();
    gone = false;
  }
}
