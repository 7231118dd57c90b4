package org.pendant.protocols.eip;

import static org.pendant.protocols.eip.EipTexts.text;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.PeriodicTasks;

/** Connections of scanners: opens and closes them, and keeps their data going. Any thread. */
final class Connections implements AutoCloseable {
  /** Most connections with cyclic data. */
  static final int MAX_CYCLIC = 32;

  /** Most connections for messages. */
  static final int MAX_EXPLICIT = 64;

  /** How often silent scanners are looked for, ns. */
  private static final long LOOK_NS = 5_000_000;

  private static final int OWNED = 1;
  private static final int NO_CYCLIC = 3 << 4;
  private static final int RUNNING = 6 << 4;
  private static final int ALL_IDLE = 7 << 4;

  private final AssemblyHandler assemblyHandler;
  private final UdpPort io;
  private final PeerLog log;
  private final ReentrantLock lock = new ReentrantLock();
  private final Map<Integer, CyclicConnection> cyclic = new HashMap<>();
  private final Map<Integer, ExplicitConnection> explicit = new HashMap<>();
  private final Map<Integer, ByteBuffer> received = new HashMap<>();

  /** Assemblies that a scanner is about to write, and those that one writes. */
  private final Set<Integer> owned = new HashSet<>();

  private final PeriodicTasks timer;
  private int lastId = 0x1000;

  /**
   * No connection yet.
   *
   * @param io where packets come and go
   */
  Connections(AssemblyHandler assemblyHandler, UdpPort io, PeerLog log) {
    this.assemblyHandler = assemblyHandler;
    this.io = io;
    this.log = log;
    timer = new PeriodicTasks(Thread.ofPlatform().daemon().name("EtherNet/IP cyclic data"), log);
    timer.withPauses(text("watchForSilentScanners"), LOOK_NS, this::look);
  }

  /** The number of the port for cyclic data. */
  int ioPort() {
    return io.number();
  }

  /**
   * Opens a connection with cyclic data.
   *
   * @param scanner where packets go to
   * @param fromScanner instance that the scanner writes
   * @param toScanner instance that the robot writes
   * @throws CipRefusal when that assembly is written already, or there are too many
   */
  CyclicConnection openCyclic(
      OpenRequest request, InetSocketAddress scanner, int fromScanner, int toScanner)
      throws CipRefusal, InterruptedException {
    CyclicConnection connection = reserve(request, scanner, fromScanner, toScanner);
    boolean mine = false;
    try {
      mine = assemblyHandler.claim(connection.owner(), fromScanner);
    } finally {
      if (!mine) {
        forget(connection);
      }
    }
    if (!mine) {
      throw CipRefusal.connection(ConnectionFault.OWNERSHIP);
    }
    lock.lock();
    try {
      long intervalNs = 1000 * request.toOriginatorUs();
      cyclic.put(connection.id(), connection);
      connection.endProductionBy(
          timer.atRate(
              text("sendingTo", connection.owner()), intervalNs, () -> produce(connection)));
    } finally {
      lock.unlock();
    }
    log.write(Level.INFO, text("writesAndReads", connection.owner(), fromScanner, toScanner));
    return connection;
  }

  private CyclicConnection reserve(
      OpenRequest request, InetSocketAddress scanner, int fromScanner, int toScanner)
      throws CipRefusal {
    lock.lock();
    try {
      refuseDuplicate(request.name());
      if (owned.size() >= MAX_CYCLIC) {
        throw CipRefusal.connection(ConnectionFault.NO_MORE);
      }
      if (!owned.add(fromScanner)) {
        throw CipRefusal.connection(ConnectionFault.OWNERSHIP);
      }
      return new CyclicConnection(
          ++lastId, request, scanner, fromScanner, toScanner, System.nanoTime());
    } finally {
      lock.unlock();
    }
  }

  private void forget(CyclicConnection connection) {
    lock.lock();
    try {
      owned.remove(connection.fromScanner());
    } finally {
      lock.unlock();
    }
  }

  private void refuseDuplicate(ConnectionName name) throws CipRefusal {
    boolean there =
        cyclic.values().stream().anyMatch(each -> each.request().name().equals(name))
            || explicit.values().stream().anyMatch(each -> each.request().name().equals(name));
    if (there) {
      throw CipRefusal.connection(ConnectionFault.DUPLICATE);
    }
  }

  /**
   * Opens a connection for messages of a session; answers its number.
   *
   * @throws CipRefusal when there are too many
   */
  int openExplicit(OpenRequest request, int session) throws CipRefusal {
    lock.lock();
    try {
      refuseDuplicate(request.name());
      if (explicit.size() >= MAX_EXPLICIT) {
        throw CipRefusal.connection(ConnectionFault.NO_MORE);
      }
      int id = ++lastId;
      explicit.put(id, new ExplicitConnection(id, session, request, System.nanoTime()));
      return id;
    } finally {
      lock.unlock();
    }
  }

  /** A message has come by a connection of a session; empty when there is no such one. */
  Optional<ExplicitConnection> explicit(int id, int session) {
    lock.lock();
    try {
      ExplicitConnection found = explicit.get(id);
      if (found == null || found.session() != session) {
        return Optional.empty();
      }
      ExplicitConnection heard = found.heardAt(System.nanoTime());
      explicit.put(id, heard);
      return Optional.of(heard);
    } finally {
      lock.unlock();
    }
  }

  /**
   * Closes a connection that a peer has opened; what it has taken is given back then.
   *
   * @throws CipRefusal when there is none of that name
   */
  void close(ConnectionName name, InetAddress peer) throws CipRefusal, InterruptedException {
    Optional<CyclicConnection> found;
    lock.lock();
    try {
      found =
          cyclic.values().stream()
              .filter(each -> each.request().name().equals(name))
              .filter(each -> each.scanner().getAddress().equals(peer))
              .findFirst();
      boolean other =
          found.isEmpty() && explicit.values().removeIf(each -> each.request().name().equals(name));
      if (found.isEmpty() && !other) {
        throw CipRefusal.connection(ConnectionFault.NOT_FOUND);
      }
      found.ifPresent(this::remove);
    } finally {
      lock.unlock();
    }
    if (found.isPresent()) {
      log.write(Level.INFO, text("wasClosed", found.get().owner()));
      release(found.get());
    }
  }

  private void remove(CyclicConnection connection) {
    connection.endProduction();
    cyclic.remove(connection.id());
  }

  /** Only afterwards may another originator write the assembly. */
  private void release(CyclicConnection connection) throws InterruptedException {
    try {
      assemblyHandler.release(connection.owner());
    } finally {
      forget(connection);
    }
  }

  private void releaseInBackground(CyclicConnection connection) {
    Thread.ofVirtual()
        .name(connection.owner() + " ending")
        .start(
            () -> {
              try {
                release(connection);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
  }

  /** The connections for messages of a session end with it; cyclic data continue. */
  void sessionEnded(int session) {
    lock.lock();
    try {
      explicit.values().removeIf(each -> each.session() == session);
    } finally {
      lock.unlock();
    }
  }

  private void produce(CyclicConnection connection) {
    // a snapshot is taken without the lock: it may have to work out where the arm is
    ByteBuffer data = assemblyHandler.toScanner(connection.toScanner());
    lock.lock();
    try {
      if (cyclic.containsKey(connection.id())) {
        io.send(connection.next(data), connection.scanner());
      }
    } finally {
      lock.unlock();
    }
  }

  /** A datagram has come; everything that is not a packet of a connection is passed over. */
  void datagram(ByteBuffer bytes, InetSocketAddress from) {
    IoPacket.decode(bytes).ifPresent(packet -> take(packet, from));
  }

  private void take(IoPacket packet, InetSocketAddress from) {
    lock.lock();
    try {
      CyclicConnection connection = cyclic.get(packet.connection());
      if (connection != null && connection.scanner().getAddress().equals(from.getAddress())) {
        connection.take(packet, System.nanoTime()).ifPresent(data -> write(connection, data));
      }
    } finally {
      lock.unlock();
    }
  }

  private void write(CyclicConnection connection, ByteBuffer data) {
    received.put(
        connection.fromScanner(), new LittleEndian().bytes(data).toBuffer().asReadOnlyBuffer());
    assemblyHandler.write(connection.owner(), connection.fromScanner(), data);
  }

  private void look() {
    long nowNs = System.nanoTime();
    lock.lock();
    try {
      if (cyclic.isEmpty() && explicit.isEmpty()) {
        return;
      }
      explicit.values().removeIf(each -> each.late(nowNs));
      List<CyclicConnection> late =
          cyclic.values().stream().filter(each -> each.late(nowNs)).toList();
      for (CyclicConnection each : late) {
        remove(each);
        log.write(Level.WARNING, text("timedOut", each.owner()));
        assemblyHandler.lost(each.owner());
        releaseInBackground(each);
      }
    } finally {
      lock.unlock();
    }
  }

  /** What a scanner has last written to an assembly. */
  Optional<ByteBuffer> received(int instance) {
    lock.lock();
    try {
      return Optional.ofNullable(received.get(instance)).map(ByteBuffer::duplicate);
    } finally {
      lock.unlock();
    }
  }

  /** Whether a scanner writes an assembly. */
  boolean connected(int instance) {
    lock.lock();
    try {
      return cyclic.values().stream().anyMatch(each -> each.fromScanner() == instance);
    } finally {
      lock.unlock();
    }
  }

  /** The status of the device (CIP volume 1, table 5-2.5): whether it is owned, and by whom. */
  int status() {
    lock.lock();
    try {
      if (cyclic.isEmpty()) {
        return NO_CYCLIC;
      }
      boolean runs = cyclic.values().stream().anyMatch(CyclicConnection::running);
      return OWNED | (runs ? RUNNING : ALL_IDLE);
    } finally {
      lock.unlock();
    }
  }

  /** Ends all connections; what they have taken is given back. */
  @Override
  public void close() {
    timer.close();
    lock.lock();
    try {
      cyclic.values().forEach(this::releaseInBackground);
      cyclic.clear();
      explicit.clear();
    } finally {
      lock.unlock();
    }
  }
}
