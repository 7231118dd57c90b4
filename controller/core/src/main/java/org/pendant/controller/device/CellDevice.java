package org.pendant.controller.device;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.wire.SignalGroupState;
import org.pendant.controller.wire.SignalOwner;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Device of the cell at work; the frame loop owns it. */
interface CellDevice {
  /** What it is called. */
  String name();

  /** What it is, for people. */
  String kind();

  /** Whether it holds a part, or sees something. */
  boolean on();

  /** How wide a part may be that is put into it, m; 0 where it holds none. */
  default double maxPartWidthM() {
    return fingers().map(Fingers::strokeM).orElse(0.0);
  }

  /** How wide the part is that is there for it to hold, m; 0 for none. */
  default double partWidthM() {
    return fingers().map(Fingers::partWidthM).orElse(0.0);
  }

  /** How far its fingers, or its door, open, m; 0 where it has none. */
  default double strokeM() {
    return fingers().map(Fingers::strokeM).orElse(0.0);
  }

  /** How far they are open now, m. */
  default double openingM() {
    return fingers().map(Fingers::openingM).orElse(0.0);
  }

  /** How hard its fingers press on a part, N. */
  default double pressN() {
    return fingers().map(Fingers::pressN).orElse(0.0);
  }

  /** What it is and where programs reach it, for people. */
  String described();

  /** The port of this controller at which programs reach it by a socket. */
  default OptionalInt port() {
    return OptionalInt.empty();
  }

  /** Whether programs reach it by a socket there. */
  default boolean isAt(String host, int port) {
    return OwnAddress.isHost(host) && port().orElse(0) == port;
  }

  /** Begins to talk at a new connection to {@link #port}. */
  default DeviceTalk connect() {
    throw new IllegalStateException(name() + " has no port");
  }

  /** The port of this controller at which programs call its procedures. */
  default OptionalInt procedurePort() {
    return OptionalInt.empty();
  }

  /**
   * Answers the call of a procedure; empty where it has none of this name.
   *
   * @throws ScriptError where it is called wrongly
   */
  default Optional<Value> call(String method, List<Value> arguments) throws ScriptError {
    return Optional.empty();
  }

  /** The signals that others are wired to, where it has some. */
  default Optional<SignalOwner> signals() {
    return Optional.empty();
  }

  /** The values of its signals; the same list until one changes. */
  default List<SignalGroupState> signalStates() {
    return List.of();
  }

  /** Its fingers, where it has some. */
  default Optional<Fingers> fingers() {
    return Optional.empty();
  }

  /**
   * Puts a part where it can hold it.
   *
   * @param widthM 0 for none
   * @return whether it can hold one
   */
  boolean putPart(double widthM);

  /** Moves it through one frame. */
  void step();
}
