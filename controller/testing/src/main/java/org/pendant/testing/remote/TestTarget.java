package org.pendant.testing.remote;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.command.Command;

/**
 * Test target: a robot elsewhere that programs under test run on. One thread uses it; nothing it is
 * asked waits for longer than a few seconds.
 */
public interface TestTarget {
  /**
   * Has these quantities told from now on, those of them that it knows.
   *
   * @param quantities by the names of RTDE
   */
  void watch(Set<String> quantities) throws TargetTrouble;

  /**
   * Gets ready for a test: ends what runs, and forgets what it has told.
   *
   * @throws TargetTrouble if it may not be controlled, or its arm cannot move
   */
  void begin() throws TargetTrouble;

  /**
   * Sends a program, which starts.
   *
   * @param script one {@code def}; bytes, one {@code char} a byte
   */
  void start(String script) throws TargetTrouble;

  /**
   * Has it do what a test asks for.
   *
   * @return why it does not
   */
  Optional<String> carryOut(Command command) throws TargetTrouble;

  /**
   * Waits for its next state.
   *
   * @throws TargetTrouble if none comes
   */
  TargetState next() throws TargetTrouble;

  /**
   * What has happened since this was asked before; never waits.
   *
   * @throws TargetTrouble if it may not be controlled any more
   */
  List<TargetEvent> events() throws TargetTrouble;

  /** The global variables of its program, as it told them last; never waits. */
  TargetVariables variables();

  /** A test has ended: ends what it has left running, and puts the speed slider back. */
  void end() throws TargetTrouble;
}
