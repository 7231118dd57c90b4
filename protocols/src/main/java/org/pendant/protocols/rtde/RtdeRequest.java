package org.pendant.protocols.rtde;

import java.nio.ByteBuffer;
import java.util.List;

/** RTDE request: what a client asks for. */
sealed interface RtdeRequest {
  /** To speak a version of the protocol from now on. */
  record ProtocolVersion(int version) implements RtdeRequest {}

  /** Which software the controller runs. */
  record ControllerVersion() implements RtdeRequest {}

  /**
   * To get fields.
   *
   * @param frequencyHz how often; any number
   * @param names of the fields, in their order
   */
  record SetupOutputs(double frequencyHz, List<String> names) implements RtdeRequest {
    /** Copies the list. */
    public SetupOutputs {
      names = List.copyOf(names);
    }
  }

  /**
   * To write fields.
   *
   * @param names of the fields, in their order
   */
  record SetupInputs(List<String> names) implements RtdeRequest {
    /** Copies the list. */
    public SetupInputs {
      names = List.copyOf(names);
    }
  }

  /**
   * A recipe that is not looked at, but answered.
   *
   * @param type of the package: outputs or inputs
   * @param reason what was found and what was expected
   */
  record RefusedSetup(int type, String reason) implements RtdeRequest {}

  /** To get data packages. */
  record Start() implements RtdeRequest {}

  /** To get none any more. */
  record Pause() implements RtdeRequest {}

  /**
   * Values to write.
   *
   * @param recipe number of the recipe
   * @param values the rest of the package
   */
  record Data(int recipe, ByteBuffer values) implements RtdeRequest {}

  /** Something for the log. */
  record Text(TextLevel level, String text) implements RtdeRequest {}

  /**
   * A package that cannot be understood and is passed over.
   *
   * @param level how bad that is
   * @param reason what was found and what was expected
   */
  record Malformed(TextLevel level, String reason) implements RtdeRequest {}
}
