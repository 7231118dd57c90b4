package org.pendant.command.rpc;

import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.language.source.Source;
import org.pendant.protocols.egress.AllowedHosts;

/** Robot source: makes of the options of a command line what a robot begins with. */
@FunctionalInterface
public interface RobotSource {
  /**
   * Understands options.
   *
   * @param words options and their values, such as {@code --robot}, {@code ur5e}
   * @throws RpcFailure if one makes no sense
   */
  NewRobot robot(List<String> words) throws RpcFailure;

  /**
   * What a robot begins with.
   *
   * @param options how its controller is switched on
   * @param waveforms what happens at its inputs while a program runs
   * @param hosts where its programs may connect to
   * @param programs reads files
   */
  record NewRobot(
      ControllerOptions options,
      InputWaveforms waveforms,
      AllowedHosts hosts,
      ProgramReader programs) {}

  /** Reads programs, scripts and trees. */
  @FunctionalInterface
  interface ProgramReader {
    /**
     * Reads one.
     *
     * @throws RpcFailure if the file cannot be read, or a part is missing that a driver has to send
     */
    ReadProgram read(String file) throws RpcFailure;
  }

  /**
   * A program that was read.
   *
   * @param source what runs; empty for a tree that cannot run
   * @param notes what people should know
   * @param problems what keeps it from running, apart from mistakes in scripts
   * @param node which node of the tree a line belongs to
   */
  record ReadProgram(
      Optional<Source> source,
      List<String> notes,
      List<String> problems,
      IntFunction<Optional<String>> node) {
    /** Copies the lists. */
    public ReadProgram {
      notes = List.copyOf(notes);
      problems = List.copyOf(problems);
    }
  }
}
