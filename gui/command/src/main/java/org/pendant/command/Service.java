package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** Service: controllers in real time with all their ports, from their start to their end. */
final class Service {
  /** How often the main thread looks whether it should end, ms. */
  private static final long LOOK_MS = 50;

  /** An arm that is not at rest by then never will be. */
  private static final long REST_NS = TimeUnit.SECONDS.toNanos(3);

  private final List<ServeOptions> options;
  private final Interruption interruption;
  private final Console console;
  private final Optional<ServedCell> cell;
  private final List<ServedRobot> robots = new ArrayList<>();

  /**
   * A service.
   *
   * @param options of each robot
   * @param cell what the robots share; empty for robots that know nothing of one another
   */
  Service(
      List<ServeOptions> options,
      Optional<ServedCell> cell,
      Interruption interruption,
      Console console) {
    this.options = options;
    this.cell = cell;
    this.interruption = interruption;
    this.console = console;
  }

  /**
   * Serves until it is told to end.
   *
   * @throws UsageException if a trace cannot be begun or the port for editors is taken
   */
  ExitCode run() throws UsageException {
    try {
      return serve();
    } finally {
      robots.forEach(ServedRobot::close);
      cell.ifPresent(ServedCell::close);
    }
  }

  private ExitCode serve() throws UsageException {
    if (cell.isPresent() && !cell.get().begin()) {
      return ExitCode.DOES_NOT_COMPILE;
    }
    for (int i = 0; i < options.size(); i++) {
      ServedRobot robot = cell.isPresent() ? cell.get().robot(i) : alone(options.get(i));
      robots.add(robot);
      if (!robot.complete()) {
        return ExitCode.UNAVAILABLE;
      }
      robot.trace();
      robot.letAttach();
    }
    for (int i = 0; i < robots.size(); i++) {
      robots.get(i).load(cell.isPresent() ? cell.get().program(i) : Optional.empty());
    }
    robots.forEach(ServedRobot::announce);
    console.print("ready");
    console.flush();
    robots.forEach(ServedRobot::printLog);
    cell.ifPresent(ServedCell::printLog);
    awaitEnd();
    comeToRest();
    return failures().findFirst().map(this::failed).orElse(ExitCode.DONE);
  }

  private ServedRobot alone(ServeOptions one) {
    String prefix = options.size() > 1 ? one.numbers().host().getHostAddress() + ": " : "";
    return ServedRobot.alone(one, console, prefix);
  }

  /** Until it is told to, all are shut down or one has failed. */
  private void awaitEnd() {
    while (!interruption.awaitRequest(LOOK_MS)
        && !robots.stream().allMatch(ServedRobot::over)
        && failures().findAny().isEmpty()) {
      // nothing to do: everything happens in other threads
    }
  }

  private Stream<Throwable> failures() {
    return robots.stream().map(ServedRobot::failure).flatMap(Optional::stream);
  }

  /** Ends the programs and lets the arms stop on their paths. */
  private void comeToRest() {
    long untilNs = System.nanoTime() + REST_NS;
    List<Future<?>> stopped = new ArrayList<>();
    robots.forEach(robot -> stopped.add(robot.stop()));
    try {
      for (int i = 0; i < robots.size(); i++) {
        robots.get(i).awaitRest(stopped.get(i), untilNs);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private ExitCode failed(Throwable fault) {
    StringWriter details = new StringWriter();
    fault.printStackTrace(new PrintWriter(details, true));
    console.complain(text("internalErrorOfServe", fault));
    console.complainInLines(details.toString().stripTrailing());
    return ExitCode.INTERNAL_ERROR;
  }
}
