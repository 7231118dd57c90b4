package org.pendant.desktop.ports;

import static org.pendant.desktop.ports.PortsTexts.text;

import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.pendant.command.service.PortWishes;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.desktop.ports.PortsState.Trouble;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.protocols.modbus.ModbusServer;
import org.pendant.protocols.net.WireTap;
import org.pendant.protocols.server.AddressRow;
import org.pendant.protocols.server.MissingPort;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.PrivilegedPort;
import org.pendant.protocols.server.RemoteControl;

/**
 * Desktop ports: opens and closes the ports of a session's controller. They follow it: with another
 * controller they are closed and opened again. Any thread; nothing here waits but what says so.
 */
public final class DesktopPorts implements SwitchListener {
  /** Where Modbus listens, beyond its standard port, when the system does not allow that. */
  private static final int UNPRIVILEGED = 1000;

  private final RobotSession session;
  private final Path logs;
  private final Consumer<String> visits;
  private final ReentrantLock lock = new ReentrantLock(true);

  // guarded by the lock
  private Optional<Wanted> wanted = Optional.empty();
  private List<OpenPorts> open = List.of();
  private boolean off;

  /**
   * What is wanted.
   *
   * @param host where to listen; empty if that is no address of this computer
   */
  private record Wanted(PortWishes wishes, Optional<InetAddress> host) {}

  private volatile RemoteControl remote = new RemoteControl(true, true);
  private volatile Optional<WireTap> tap = Optional.empty();
  private volatile PortsState state = PortsState.CLOSED;

  /**
   * Closed ports.
   *
   * @param logs folder for log files and reports of clients
   * @param visits takes which client has come or left; any thread
   */
  public DesktopPorts(RobotSession session, Path logs, Consumer<String> visits) {
    this.session = session;
    this.logs = logs;
    this.visits = visits;
    session.addSwitchListener(this);
  }

  /** Whether they are open, or why not. */
  PortsState state() {
    return state;
  }

  /** Whether clients may control the robot. */
  boolean remote() {
    return remote.remote();
  }

  /** Lets clients control the robot, or only ask; those that are connected notice. */
  void setRemote(boolean allowed) {
    remote.setRemote(allowed);
  }

  /**
   * Has {@code listener} hear from now on what goes over all connections, also when the ports are
   * opened later; empty for nobody.
   */
  void tap(Optional<WireTap> listener) {
    tap = listener;
    inBackground(
        () -> {
          lock.lock();
          try {
            open.forEach(each -> each.tap(tap));
          } finally {
            lock.unlock();
          }
        });
  }

  /** The robot time, s. */
  double robotTimeS() {
    return session.state().timeS();
  }

  /** Begins to open them, as {@code wishes} say; {@link #state} tells what came of it. */
  public void open(PortWishes wishes) {
    state = new PortsState.Opening();
    inBackground(
        () -> {
          try {
            want(Optional.of(wishes));
          } catch (RuntimeException | Error fault) {
            // they are not open, and can be tried again
            state = trouble(PortField.OFFSET, text("internalError", fault));
            throw fault;
          }
        });
  }

  /** Begins to close them. */
  public void close() {
    inBackground(() -> want(Optional.empty()));
  }

  private static void inBackground(Runnable task) {
    Thread.ofVirtual().name("ports").start(task);
  }

  /** Opens them as they are wanted, or closes them; waits until that is done. */
  void want(Optional<PortWishes> wishes) {
    // Asks a name server perhaps, so without the lock: who closes the window must not wait for it.
    Optional<Wanted> next = wishes.map(each -> new Wanted(each, local(each.host())));
    lock.lock();
    try {
      wanted = next;
      carryOut();
    } finally {
      lock.unlock();
    }
  }

  private void carryOut() {
    closeNow();
    state = wanted.isPresent() && !off ? opened(wanted.get()) : PortsState.CLOSED;
    if (state instanceof PortsState.Closed) {
      // a later controller does not try again what has failed
      wanted = off ? wanted : Optional.empty();
    }
  }

  private void closeNow() {
    open.forEach(OpenPorts::close);
    open = List.of();
  }

  private static Optional<InetAddress> local(String name) {
    if (name.isBlank()) {
      return Optional.empty();
    }
    try {
      InetAddress host = InetAddress.getByName(name);
      boolean here =
          host.isLoopbackAddress()
              || host.isAnyLocalAddress()
              || NetworkInterface.getByInetAddress(host) != null;
      return here ? Optional.of(host) : Optional.empty();
    } catch (UnknownHostException | SocketException e) {
      // told at the field, as an address that is another computer's
      return Optional.empty();
    }
  }

  private PortsState opened(Wanted now) {
    PortWishes wishes = now.wishes();
    if (!Files.isDirectory(wishes.programs())) {
      return trouble(PortField.PROGRAMS, text("isNoFolder", wishes.programs()));
    }
    if (now.host().isEmpty()) {
      return trouble(PortField.HOST, text("isNoAddressOfThisComputer", wishes.host()));
    }
    InetAddress host = now.host().get();
    RemoteControl control = new RemoteControl(true, wishes.remote());
    List<OpenPorts> made = new ArrayList<>();
    List<PortsState.OpenPort> ports = new ArrayList<>();
    List<MissingPort> missing = new ArrayList<>();
    Set<InetAddress> taken = new HashSet<>();
    // the controller of a cell's script has none
    for (SessionMember member :
        session.members().stream().filter(each -> !each.armless()).toList()) {
      Optional<InetAddress> own = address(member, host, made.size());
      if (own.isEmpty() || !taken.add(own.get())) {
        made.forEach(OpenPorts::close);
        return trouble(
            PortField.HOST,
            own.map(each -> text("isTheAddressOfAnotherArm", each.getHostAddress()))
                .orElse(text("mustBeTheFirstOfA", wishes.host())));
      }
      OpenPorts each =
          OpenPorts.open(
              member,
              numbers(own.get(), wishes),
              control,
              ProgramsFolder.at(wishes.programs()),
              session.inCell() ? logs.resolve(member.name()) : logs,
              visits,
              () -> inBackground(this::switchingOff));
      made.add(each);
      each.ports()
          .forEach(
              port -> ports.add(new PortsState.OpenPort(member.name(), words(own.get()), port)));
      missing.addAll(each.missing());
    }
    if (ports.isEmpty()) {
      made.forEach(OpenPorts::close);
      return trouble(PortField.OFFSET, missing.getFirst().why());
    }
    made.forEach(each -> each.tap(tap));
    open = List.copyOf(made);
    remote = control;
    return new PortsState.Open(
        words(host), taken.stream().anyMatch(each -> !each.isLoopbackAddress()), ports, missing);
  }

  private static String words(InetAddress host) {
    String address = host.getHostAddress();
    return address.contains(":") ? "[" + address + "]" : address;
  }

  /**
   * Where an arm has its ports: where the file of the cell wants them, or else at the first address
   * and those that follow it; empty where none follows. Ports of all interfaces are not those of a
   * file, which names addresses of this computer alone.
   */
  private static Optional<InetAddress> address(
      SessionMember member, InetAddress first, int number) {
    return member.address().isPresent() && first.isLoopbackAddress()
        ? member.address().map(InetAddress::ofLiteral)
        : number == 0 ? Optional.of(first) : AddressRow.after(first, number);
  }

  private static PortsState trouble(PortField field, String text) {
    return new PortsState.Closed(Optional.of(new Trouble(field, text)));
  }

  private static PortNumbers numbers(InetAddress host, PortWishes wishes) {
    PortNumbers numbers = new PortNumbers(host, wishes.offset(), false);
    int standard = ModbusServer.STANDARD_PORT;
    if (wishes.modbus().isPresent()) {
      return numbers.with(standard, wishes.modbus().getAsInt());
    }
    return PrivilegedPort.forbidden(numbers, standard)
        ? numbers.with(standard, UNPRIVILEGED + standard + wishes.offset())
        : numbers;
  }

  /** Closes the ports; waits until that is done. */
  @Override
  public void switchingOff() {
    lock.lock();
    try {
      off = true;
      // the choice between local and remote control outlives the controller
      wanted =
          wanted.map(each -> new Wanted(each.wishes().withRemote(remote.remote()), each.host()));
      carryOut();
    } finally {
      lock.unlock();
    }
  }

  /** Opens them again where they are wanted; waits until that is done. */
  @Override
  public void switchedOn() {
    lock.lock();
    try {
      off = false;
      carryOut();
    } finally {
      lock.unlock();
    }
  }
}
