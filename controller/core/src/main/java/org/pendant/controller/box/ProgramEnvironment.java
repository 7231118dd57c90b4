package org.pendant.controller.box;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.file.ProgramsFolder;

/** Environment of the program that runs, or ran last: its files and its random numbers. */
public final class ProgramEnvironment {
  // not the service-loaded generators: looking one up costs more than a short program's run
  private final RandomGenerator random;
  private ProgramsFolder programsFolder;
  private Optional<TestBench> testBench = Optional.empty();

  /**
   * An environment.
   *
   * @param seed of the random numbers, which are those of the box and not of each program
   */
  ProgramEnvironment(ProgramsFolder programsFolder, long seed) {
    this.programsFolder = programsFolder;
    random = new SplittableRandom(seed);
  }

  /** Where the program may read files. */
  public ProgramsFolder programsFolder() {
    return programsFolder;
  }

  /** A program that may read files there is about to run. */
  public void setProgramsFolder(ProgramsFolder folder) {
    programsFolder = folder;
  }

  /** The bench of the test that runs on this box; empty where it is not under test. */
  public Optional<TestBench> testBench() {
    return testBench;
  }

  /** Puts the box under test. */
  public void attach(TestBench bench) {
    testBench = Optional.of(bench);
  }

  /** Random numbers. */
  public RandomGenerator random() {
    return random;
  }
}
