package org.pendant.testing.run;

import java.util.List;
import java.util.stream.IntStream;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.FileWarnings;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestFile;

/** Test plan: the tests that are going to run, and the files that cannot. Immutable. */
public final class TestPlan {

  /** One test that is to be run. */
  record Chosen(TestFile file, TestPrograms programs, TestCase test) {
    /** The same test with a limit to its robot time. */
    Chosen within(double timeoutS) {
      return new Chosen(file, programs, test.within(timeoutS));
    }
  }

  private final List<Chosen> chosen;
  private final List<BrokenTestFile> broken;
  private final List<FileWarnings> warnings;

  TestPlan(List<Chosen> chosen, List<BrokenTestFile> broken, List<FileWarnings> warnings) {
    this.chosen = List.copyOf(chosen);
    this.broken = List.copyOf(broken);
    this.warnings = List.copyOf(warnings);
  }

  /** The tests, in the order of the report. */
  public List<TestCase> tests() {
    return chosen.stream().map(Chosen::test).toList();
  }

  /** What is wrong with files of which no test can run. */
  public List<BrokenTestFile> broken() {
    return broken;
  }

  /** What people should look at in files, whether their tests are chosen or not. */
  public List<FileWarnings> warnings() {
    return warnings;
  }

  List<Chosen> chosen() {
    return chosen;
  }

  /**
   * One of several parts of this plan, which together are all of it; each has tests of every file.
   *
   * @param number from 1 to {@code count}
   * @param count 1 or more
   */
  public TestPlan shard(int number, int count) {
    if (number < 1 || number > count) {
      throw new IllegalArgumentException("shard is " + number + ", must be 1 to " + count);
    }
    List<Chosen> own =
        IntStream.range(0, chosen.size())
            .filter(i -> i % count == number - 1)
            .mapToObj(chosen::get)
            .toList();
    return new TestPlan(own, broken, warnings);
  }
}
