package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.testing.run.TestSettings;
import org.pendant.testing.source.TestCase;

/**
 * Test options: what {@code pendant test} was asked for.
 *
 * @param settings how tests are run
 * @param names parts of names, of which a test's own has one; empty for all
 * @param tags of which a test has one; empty for all
 * @param shardNumber which part of all tests, from 1
 * @param shardCount into how many parts they are split
 */
record TestOptions(
    TestSettings settings,
    List<String> names,
    List<String> tags,
    List<String> otherTags,
    int shardNumber,
    int shardCount) {
  private static final int MAX_JOBS = 256;
  private static final Pattern SHARD_FORM = Pattern.compile("(\\d{1,6})/(\\d{1,6})");

  static final Option FILTER =
      Option.text("--filter", "TEXT")
          .repeated()
          .documented(
              "grip",
              "run only tests whose `FILE:NAME` contains this text; may be repeated, then one of"
                  + " them is enough");
  static final Option TAG =
      Option.text("--tag", "TAG")
          .repeated()
          .documented("fast", "run only tests with this tag; may be repeated");
  static final Option NOT_TAG =
      Option.text("--not-tag", "TAG")
          .repeated()
          .documented("slow", "leave out tests with this tag; may be repeated");
  static final Option SHARD =
      Option.text("--shard", "I/N")
          .documented("1/4", "run the first of four parts of the tests, for machines side by side");
  static final Option FAIL_FAST = Option.flag("--fail-fast");
  static final Option SEED =
      Option.text("--seed", "N")
          .explained("--seed.test")
          .documented(
              "4711",
              "repeat the order, and what `random()` gives, of a run that printed this seed;"
                  + " without it each run has another one");
  static final Option JOBS =
      Option.of("--jobs", new OptionArgument.Whole("N", 1, MAX_JOBS))
          .documented("2", "how many tests run at once; default as many as there are processors");
  static final Option TIMEOUT =
      Option.of("--timeout", RunOptions.SECONDS)
          .explained("--timeout.test")
          .standing(Integer.toString((int) TestSettings.STANDARD_TIMEOUT_S))
          .documented(
              "S", "how much robot time a test may take that has no `@timeout`, default 300 s");
  static final Option WALL_TIMEOUT =
      Option.of("--wall-timeout", RunOptions.SECONDS)
          .explained("--wall-timeout.test")
          .standing(Long.toString(TestSettings.STANDARD_WALL_TIMEOUT.toSeconds()))
          .documented("S", "how long a test may take on this computer, default 60 s");

  /** Those that say which tests run and how. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(FILTER, TAG, NOT_TAG, SHARD, FAIL_FAST, SEED, JOBS, TIMEOUT, WALL_TIMEOUT),
              RunOptions.OF_TESTS.stream())
          .toList();

  static TestOptions of(Arguments arguments) throws UsageException {
    CellFile.refuse(arguments);
    long seed = seed(arguments);
    OptionalInt jobs = arguments.whole(JOBS);
    OptionalDouble timeoutS = arguments.number(TIMEOUT);
    OptionalDouble wallS = arguments.number(WALL_TIMEOUT);
    TestSettings settings =
        new TestSettings(
            RunOptions.controller(arguments).withSeed(seed),
            seed,
            jobs.orElse(Runtime.getRuntime().availableProcessors()),
            timeoutS.orElseThrow(),
            Duration.ofNanos((long) (1e9 * Math.min(wallS.orElseThrow(), 1e9))),
            arguments.has(FAIL_FAST));
    int[] shard = shard(arguments);
    return new TestOptions(
        settings,
        arguments.values(FILTER),
        arguments.values(TAG),
        arguments.values(NOT_TAG),
        shard[0],
        shard[1]);
  }

  /** Six digits, so that people can type it again. */
  private static long seed(Arguments arguments) throws UsageException {
    Optional<String> text = arguments.value(SEED);
    if (text.isEmpty()) {
      return ThreadLocalRandom.current().nextInt(1, 1_000_000);
    }
    try {
      return Long.parseLong(text.get());
    } catch (NumberFormatException e) {
      throw new UsageException(text("seedMustBe", text.get()));
    }
  }

  private static int[] shard(Arguments arguments) throws UsageException {
    Optional<String> text = arguments.value(SHARD);
    if (text.isEmpty()) {
      return new int[] {1, 1};
    }
    Matcher form = SHARD_FORM.matcher(text.get());
    if (form.matches()) {
      int number = Integer.parseInt(form.group(1));
      int count = Integer.parseInt(form.group(2));
      if (number >= 1 && number <= count) {
        return new int[] {number, count};
      }
    }
    throw new UsageException(text("shardMustBe", text.get()));
  }

  /** Whether a test is one of those that are asked for. */
  boolean wants(TestCase test) {
    String name = test.id().file() + ":" + test.id().name();
    return (names.isEmpty() || names.stream().anyMatch(name::contains))
        && (tags.isEmpty() || tags.stream().anyMatch(each -> test.tags().contains(each)))
        && otherTags.stream().noneMatch(each -> test.tags().contains(each));
  }
}
