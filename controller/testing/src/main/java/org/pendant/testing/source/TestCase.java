package org.pendant.testing.source;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SortedSet;
import org.pendant.models.arm.Joints;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;

/**
 * Test case: one test as it stands in a file, before it runs.
 *
 * @param id which it is
 * @param number its number in the file, from 0
 * @param place where its definition begins
 * @param tags what it is marked with, sorted
 * @param skip why it does not run
 * @param timeoutS how much robot time it may take, where it says so itself
 * @param startRad where the arm stands at first, where it says so itself
 * @param scene what stands around the arm, where it says so itself
 * @param property how it is run with many values; empty for a test that runs once
 * @param golden how it is compared with a recording of itself; empty for a test that is not
 * @param watches whether it starts programs, and so runs beside them; else it is the program
 */
public record TestCase(
    TestId id,
    int number,
    TestPlace place,
    SortedSet<String> tags,
    Optional<String> skip,
    OptionalDouble timeoutS,
    Optional<Joints> startRad,
    Optional<TestScene> scene,
    Optional<Property> property,
    Optional<GoldenMark> golden,
    boolean watches) {

  /**
   * A test that is run with many values.
   *
   * @param runs how often, 1 or more
   * @param examples choices of runs that come first, as a report has named them
   */
  public record Property(int runs, List<List<Double>> examples) {
    public Property {
      examples = List.copyOf(examples);
    }
  }

  /** The same test with a limit to the robot time of a run, unless its own is shorter. */
  public TestCase within(double limitS) {
    OptionalDouble shortest = OptionalDouble.of(Math.min(limitS, timeoutS.orElse(limitS)));
    return new TestCase(
        id, number, place, tags, skip, shortest, startRad, scene, property, golden, watches);
  }
}
