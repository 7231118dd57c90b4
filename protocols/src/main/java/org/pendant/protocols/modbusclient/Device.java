package org.pendant.protocols.modbusclient;

import java.io.EOFException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.NoRouteToHostException;
import java.net.ProtocolException;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.protocols.egress.HostNotAllowed;
import org.pendant.protocols.egress.HostPolicy;

/**
 * Device and everything that is wanted of it. A thread of its own keeps a connection as long as
 * there is something, makes it again when it is lost, and asks; others only leave wishes and wake
 * it.
 */
final class Device {
  private static final int CONNECT_MS = 2_000;

  /** How long it waits before it connects again. */
  private static final long RETRY_NS = TimeUnit.MILLISECONDS.toNanos(500);

  /** How long the last writes have. */
  private static final long LAST_WRITES_NS = TimeUnit.SECONDS.toNanos(2);

  private final ModbusAddress address;
  private final HostPolicy hostPolicy;
  private final Consumer<Device> afterwards;
  private final List<Point> points = new CopyOnWriteArrayList<>();
  private final List<CustomCommand> commands = new CopyOnWriteArrayList<>();
  private final AtomicInteger resets = new AtomicInteger();
  private final CountDownLatch over = new CountDownLatch(1);
  private final Thread thread;
  private volatile int resetsDone;
  private volatile boolean closing;
  private volatile long closingSinceNs;
  private boolean oneByOne;
  private boolean begun;
  private boolean ended;

  /**
   * A device; its thread starts with the first wish.
   *
   * @param afterwards told when nothing is wanted of it any more
   */
  Device(ModbusAddress address, HostPolicy hostPolicy, Consumer<Device> afterwards) {
    this.address = address;
    this.hostPolicy = hostPolicy;
    this.afterwards = afterwards;
    thread = Thread.ofVirtual().name("Modbus " + address).unstarted(this::run);
  }

  ModbusAddress address() {
    return address;
  }

  // --- for the frame loop

  /** Adds a signal; false when this has come to its end. */
  synchronized boolean add(Point point) {
    return !ended && points.add(point) && wakeOrStart();
  }

  /** Adds a command; false when this has come to its end. */
  synchronized boolean add(CustomCommand command) {
    return !ended && commands.add(command) && wakeOrStart();
  }

  private boolean wakeOrStart() {
    if (begun) {
      wake();
    } else {
      begun = true;
      thread.start();
    }
    return true;
  }

  void remove(Point point) {
    points.remove(point);
    wake();
  }

  /** Has the thread look what is wanted. */
  void wake() {
    LockSupport.unpark(thread);
  }

  /** Closes the connection and makes it again. */
  synchronized void reconnect() {
    resets.incrementAndGet();
    // it may be in the middle of connecting
    thread.interrupt();
  }

  /** Whether that has been asked for and not yet begun. */
  boolean reconnecting() {
    return resets.get() != resetsDone;
  }

  /** Sends what was set, and ends. */
  void close() {
    closingSinceNs = System.nanoTime();
    closing = true;
    if (points.stream().anyMatch(Point::unsent)) {
      wake();
    } else {
      // it may be in the middle of connecting
      thread.interrupt();
    }
  }

  /** Waits until that is done. */
  void awaitEnd() {
    try {
      if (!over.await(LAST_WRITES_NS, TimeUnit.NANOSECONDS)) {
        thread.interrupt();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  // --- for the thread

  boolean closing() {
    return closing;
  }

  /** Whether the device must answer before it is asked again. */
  boolean sequential() {
    return oneByOne || points.stream().map(Point::exchange).anyMatch(ModbusExchange::sequential);
  }

  /** It did not take several questions at once: from now on it is asked one by one. */
  void askOneByOne() {
    oneByOne = true;
  }

  /** Who may want something, commands first. */
  List<? extends Asker> askers() {
    commands.removeIf(CustomCommand::over);
    if (commands.isEmpty()) {
      return points;
    }
    List<Asker> all = new ArrayList<>(commands);
    all.addAll(points);
    return all;
  }

  /** Whether a connection is of use. */
  boolean wantsToTalk() {
    return !reconnecting() && !finished();
  }

  private boolean finished() {
    commands.removeIf(CustomCommand::over);
    if (closing) {
      return System.nanoTime() - closingSinceNs > LAST_WRITES_NS
          || points.stream().noneMatch(Point::unsent);
    }
    return points.isEmpty() && commands.isEmpty();
  }

  private void run() {
    try {
      while (!end()) {
        talk();
      }
    } finally {
      afterwards.accept(this);
      over.countDown();
    }
  }

  private synchronized boolean end() {
    ended = finished();
    return ended;
  }

  private void talk() {
    beginAnew();
    boolean before = oneByOne;
    try (Socket socket = hostPolicy.connect(address.host(), address.port(), CONNECT_MS)) {
      new Conversation(this, socket).run();
    } catch (IOException e) {
      // on a new connection it does not mix up what it has not read yet
      if (!reconnecting() && oneByOne == before) {
        failed(error(e));
      }
    }
  }

  /** One with {@link #reconnect}: a late interrupt would break off the new connection. */
  private synchronized void beginAnew() {
    // what interrupted it has been seen to, or is seen to here
    boolean _ = Thread.interrupted();
    int asked = resets.get();
    if (asked != resetsDone) {
      lost(ModbusErrors.DISCONNECTED);
      resetsDone = asked;
    }
  }

  private void failed(int error) {
    lost(error);
    for (CustomCommand command : commands) {
      command.failed(error);
    }
    if (closing) {
      // no program is there that could be told
      points.clear();
    } else {
      LockSupport.parkNanos(this, RETRY_NS);
    }
  }

  private void lost(int error) {
    for (Point point : points) {
      point.disconnected(error);
    }
  }

  private static int error(IOException why) {
    return switch (why) {
      case HostNotAllowed e -> ModbusErrors.NOT_ALLOWED;
      case ProtocolException e -> ModbusErrors.PROTOCOL;
      case SocketTimeoutException e -> ModbusErrors.NO_ANSWER;
      case UnknownHostException e -> ModbusErrors.NO_HOST;
      case NoRouteToHostException e -> ModbusErrors.NO_HOST;
      case EOFException e -> ModbusErrors.DISCONNECTED;
      case ConnectException e -> ModbusErrors.REFUSED;
      case SocketException e -> ModbusErrors.RESET;
      default -> ModbusErrors.NETWORK;
    };
  }
}
