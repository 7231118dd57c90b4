package org.pendant.protocols.primary;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Robot;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.protocols.net.Connection;
import org.pendant.protocols.script.ScriptTrouble;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramLabel;

/**
 * Primary feed: sends the same to all clients of a kind: the state every 50 frames and when a mode
 * changes, messages in the frame in which something happens. One at a time changes who listens or
 * sends, so that a new client gets its greeting first and misses nothing after it.
 */
final class PrimaryFeed {
  /** Frames from one state to the next: ten a second. */
  static final int PERIOD_FRAMES = 50;

  private static final byte[] NO_SIGNALS = {0, 0, 0, 9, 5, 0, 0, 0, 0};

  private final Robot robot;
  private final RobotStateCodec states;
  private final List<Connection> primary = new ArrayList<>();
  private final List<Connection> secondary = new ArrayList<>();
  private final byte[] version = RobotMessageCodec.encode(new RobotMessage.Version());
  private final byte[] second = RobotMessageCodec.encode(new RobotMessage.Second());
  private ControllerState last;
  private ControllerState lastFull;
  private VariableSamples lastVariables = VariableSamples.NONE;
  private List<ProgramLabel> labels = List.of();
  private Optional<ProgramLabel> lastLabel = Optional.empty();
  private long lastEntry;
  private int lastLine;
  private int frames;

  PrimaryFeed(Robot robot) {
    this.robot = robot;
    last = robot.state();
    lastEntry = last.newestEntry();
    states = new RobotStateCodec(last.arm().description());
    lastFull = last;
  }

  /** A client of the primary port. */
  synchronized void addPrimary(Connection client) {
    greet(client);
    if (!lastVariables.globals().isEmpty()) {
      long timeUs = EventMessages.timeUs(last);
      VariablePackages.setup(timeUs, lastVariables.globals()).forEach(client::send);
      VariablePackages.update(timeUs, lastVariables.globals()).forEach(client::send);
    }
    client.send(states.full(last));
    primary.add(client);
  }

  /** A client of the secondary port. */
  synchronized void addSecondary(Connection client) {
    greet(client);
    client.send(states.full(last));
    secondary.add(client);
  }

  private void greet(Connection client) {
    client.send(version);
    client.send(second);
  }

  /** The client has gone. */
  synchronized void remove(Connection client) {
    primary.remove(client);
    secondary.remove(client);
  }

  /** A client's script did not run. */
  synchronized void tell(ScriptTrouble trouble) {
    byte[] message =
        RobotMessageCodec.encode(EventMessages.of(EventMessages.timeUs(last), trouble));
    // not send: what one client does wrong must not disconnect another one that reads slowly
    primary.forEach(client -> client.stream(message));
  }

  /** A frame has ended. */
  synchronized void frame(ControllerState state) {
    ControllerState before = last;
    List<LogEntry> entries = entries(state);
    last = state;
    if (modesDiffer(before, state)) {
      // first, so that a client that acts on a message finds the state that belongs to it
      sendState(state);
    }
    if (!primary.isEmpty()) {
      for (RobotMessage message : EventMessages.of(state, entries, before.safety().safetyMode())) {
        byte[] bytes = RobotMessageCodec.encode(message);
        primary.forEach(client -> client.send(bytes));
      }
    }
    followLabels(state);
    frames++;
    if (frames >= PERIOD_FRAMES) {
      frames = 0;
      sendState(state);
    }
  }

  private static boolean modesDiffer(ControllerState one, ControllerState other) {
    return one.safety().safetyMode() != other.safety().safetyMode()
        || one.safety().robotMode() != other.safety().robotMode();
  }

  /** Tells when the main thread has passed another label. */
  private void followLabels(ControllerState state) {
    for (ProgramEvent event : state.newProgramEvents()) {
      if (event instanceof ProgramEvent.Started started) {
        labels = started.labels();
        lastLabel = Optional.empty();
      }
    }
    boolean stays = state.program().line() == lastLine && lastLabel.isPresent();
    lastLine = state.program().line();
    if (labels.isEmpty() || lastLine == 0 || stays) {
      return;
    }
    Optional<ProgramLabel> now = ProgramLabel.at(labels, lastLine);
    if (now.isPresent() && !now.equals(lastLabel)) {
      lastLabel = now;
      byte[] message =
          RobotMessageCodec.encode(
              new RobotMessage.Labels(
                  EventMessages.timeUs(state),
                  now.get().number(),
                  now.get().text(),
                  state.program().name()));
      primary.forEach(client -> client.stream(message));
    }
  }

  /** Log lines since the last that were seen; one in place of those that are gone already. */
  private List<LogEntry> entries(ControllerState state) {
    if (state.newestEntry() <= lastEntry) {
      return List.of();
    }
    List<LogEntry> entries = new ArrayList<>(robot.logSince(lastEntry));
    long missed = entries.getFirst().number() - lastEntry - 1;
    if (missed > 0) {
      String text = missed + " lines of the log were not sent in time";
      entries.addFirst(
          new LogEntry(0, state.timeS(), LogEntry.Level.WARNING, LogEntry.Origin.SCRIPT, text));
    }
    lastEntry = entries.getLast().number();
    return entries;
  }

  private void sendState(ControllerState state) {
    List<byte[]> packages = variables(state);
    if (primary.isEmpty() && secondary.isEmpty()) {
      return;
    }
    boolean full = configurationChanged(state);
    byte[] bytes = full ? states.full(state) : states.periodic(state);
    if (full) {
      lastFull = state;
    }
    secondary.forEach(client -> client.stream(bytes));
    packages.add(NO_SIGNALS);
    packages.add(bytes);
    byte[] together = joined(packages);
    primary.forEach(client -> client.stream(together));
  }

  private static byte[] joined(List<byte[]> packages) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    packages.forEach(all::writeBytes);
    return all.toByteArray();
  }

  private boolean configurationChanged(ControllerState state) {
    return state.safety().robotMode() != lastFull.safety().robotMode()
        || !state.arm().tool().equals(lastFull.arm().tool())
        || !state.readings().payload().equals(lastFull.readings().payload());
  }

  /** Names when a program has started or got more variables, values when one has changed. */
  private List<byte[]> variables(ControllerState state) {
    VariableSamples now = state.variables();
    VariableSamples before = lastVariables;
    lastVariables = now;
    List<byte[]> packages = new ArrayList<>();
    if (primary.isEmpty()) {
      return packages;
    }
    long timeUs = EventMessages.timeUs(state);
    if (now.run() != before.run() || now.globals().size() != before.globals().size()) {
      packages.addAll(VariablePackages.setup(timeUs, now.globals()));
    }
    if (!now.equals(before)) {
      packages.addAll(VariablePackages.update(timeUs, now.globals()));
    }
    if (packages.isEmpty()) {
      packages.add(VariablePackages.empty());
    }
    return packages;
  }
}
