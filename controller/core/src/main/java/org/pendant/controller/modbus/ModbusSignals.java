package org.pendant.controller.modbus;

import static org.pendant.controller.modbus.ModbusSignalTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusConnector;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.Pending;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.message.MessageLog;
import org.pendant.script.value.ScriptError;

/**
 * The Modbus signals of a controller by their names (manual 18.18 to 18.31, 19.1). They outlive the
 * program that added them: outputs are to follow what programs do. The frame loop owns this.
 */
public final class ModbusSignals {
  /** Most signals of a controller. */
  public static final int MOST = 1000;

  private final ModbusConnector door;
  private final MessageLog log;
  private final Map<String, ModbusSignal> byName = new LinkedHashMap<>();
  private List<ModbusSignal> signals = List.of();
  private List<ModbusSignalState> state = List.of();
  private boolean changed;
  private double timeS;

  /** Signals by way of {@code door}; what is wrong with them goes to {@code log}. */
  public ModbusSignals(ModbusConnector door, MessageLog log) {
    this.door = door;
    this.log = log;
  }

  /**
   * Adds a signal; one that has the name already is replaced.
   *
   * @throws ScriptError when there is no way out, or there are too many
   */
  public void add(String name, ModbusExchange exchange) throws ScriptError {
    if (byName.size() >= MOST && !byName.containsKey(name)) {
      throw new ScriptError("too-many-signals", text("mostSignals", MOST));
    }
    ModbusSignal added = new ModbusSignal(name, exchange, door.add(exchange), timeS);
    ModbusSignal before = byName.put(name, added);
    // only now, so that a connection that both use stays
    if (before != null) {
      before.point().end();
    }
    listAgain();
  }

  /**
   * Ends a signal.
   *
   * @throws ScriptError when there is none
   */
  public void delete(String name) throws ScriptError {
    ModbusSignal deleted = signal(name);
    byName.remove(name);
    deleted.point().end();
    listAgain();
  }

  private void listAgain() {
    signals = List.copyOf(byName.values());
    changed = true;
  }

  /**
   * The signal of that name.
   *
   * @throws ScriptError when there is none
   */
  public ModbusSignal signal(String name) throws ScriptError {
    ModbusSignal found = byName.get(name);
    if (found == null) {
      throw new ScriptError("unknown-signal", text("unknownSignal", name));
    }
    return found;
  }

  /**
   * Sends a request that the program has made.
   *
   * @throws ScriptError when there is no way out
   */
  public Pending send(ModbusAddress device, int unit, int function, byte[] data)
      throws ScriptError {
    return door.send(device, unit, function, data);
  }

  /**
   * Closes the connections to a device and makes them again.
   *
   * @param port empty for every port of that host that signals are at
   * @return whether there is any
   */
  public boolean reconnect(String host, Optional<Integer> port) {
    List<ModbusSignal> there = at(host, port);
    there.forEach(each -> each.point().reconnect());
    return !there.isEmpty();
  }

  /** Whether all signals of a device have been answered since their connection was made. */
  public boolean connected(String host, Optional<Integer> port) {
    return at(host, port).stream().allMatch(ModbusSignals::connected);
  }

  /** Now, and in what programs see in this frame. */
  private static boolean connected(ModbusSignal signal) {
    return signal.point().reading().connectionError() == 0
        && signal.reading().connectionError() == 0;
  }

  private List<ModbusSignal> at(String host, Optional<Integer> port) {
    List<ModbusSignal> there = new ArrayList<>();
    for (ModbusSignal each : signals) {
      ModbusAddress device = each.exchange().device();
      if (device.host().equals(host) && port.orElse(device.port()) == device.port()) {
        there.add(each);
      }
    }
    return there;
  }

  /** Whether devices are being spoken to that do not live in robot time. */
  public boolean reachOutside() {
    for (int i = 0; i < signals.size(); i++) {
      if (!signals.get(i).point().inRobotTime()) {
        return true;
      }
    }
    return false;
  }

  /** Whether signals of a device wait for who does not live in robot time. */
  public boolean reachOutside(String host, Optional<Integer> port) {
    return at(host, port).stream().anyMatch(each -> !each.point().inRobotTime());
  }

  /** A frame begins: takes what has come since the last one. */
  public void step(double frameTimeS) {
    timeS = frameTimeS;
    for (int i = 0; i < signals.size(); i++) {
      ModbusSignal signal = signals.get(i);
      boolean wasFine = signal.reading().valid();
      if (signal.step(frameTimeS)) {
        report(signal, wasFine);
      }
    }
  }

  /** One line for a device that has gone, however many signals are there. */
  private void report(ModbusSignal signal, boolean wasFine) {
    int connection = signal.reading().connectionError();
    boolean fresh = connection == ModbusErrors.DISCONNECTED && !wasFine;
    if (signal.reading().valid() || fresh) {
      return;
    }
    log.warnOnce(
        connection == 0
            ? text("signalFault", signal.name(), ModbusErrors.of(signal.reading()))
            : text("deviceFault", signal.exchange().device(), ModbusErrors.connection(connection)));
  }

  /** Whether an input with that action is high and so asks for freedrive (manual 18.23). */
  public boolean freedriveDemanded() {
    for (int i = 0; i < signals.size(); i++) {
      if (signals.get(i).freedriveDemanded(timeS)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Chooses what an output does when programs start and end; at once where that says something
   * about now (manual 19.1).
   *
   * @param now the level that it asks for now
   */
  public void chooseRunState(ModbusSignal signal, RunStateAction action, Optional<Boolean> now) {
    signal.chooseRunState(action);
    now.ifPresent(signal::setAll);
  }

  /** Something has happened that outputs may follow: {@code level} says to what. */
  public void follow(Function<RunStateAction, Optional<Boolean>> level) {
    for (ModbusSignal signal : signals) {
      level.apply(signal.runState()).ifPresent(signal::setAll);
    }
  }

  /** All signals in the order in which they were added; the same list until one changes. */
  public List<ModbusSignalState> state() {
    for (int i = 0; i < signals.size(); i++) {
      changed |= signals.get(i).takeChanged();
    }
    if (changed) {
      changed = false;
      // such a list is taken into each snapshot as it is
      state = List.copyOf(signals.stream().map(ModbusSignal::state).toList());
    }
    return state;
  }
}
