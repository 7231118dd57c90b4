package org.pendant.testing.mutation;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReferenceArray;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Source;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestId;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.LineCoverage;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.run.TestTrial;
import org.pendant.testing.source.TestSources;

/**
 * Mutation run: makes mistakes in the programs that tests reach, one at a time, and runs the tests
 * that reach that line until one of them is red.
 */
public final class MutationRun {
  private static final String SCRIPT = ".script";
  private static final String TREE = ".pendant";

  private final TestSources files;
  private final TestRunner runner;
  private final MutationSettings settings;
  private final Map<String, TestResult> usual = new HashMap<>();

  /** Lists of tests, each once: the lines of a function have the same ones. */
  private final Map<List<String>, List<TestId>> orders = new HashMap<>();

  private final ProgressListener progress;
  private int tried;

  /** Is told how far the run has come. */
  @FunctionalInterface
  public interface ProgressListener {
    /** So many mutants of all have been tried; by any thread, but by one at a time. */
    void tried(int mutants, int all);
  }

  /** A mutation of one file that has been chosen. */
  private record Chosen(int file, Mutation mutation, List<TestId> covering) {}

  /**
   * A run.
   *
   * @param files that tests and programs are in
   * @param runner that ran the tests; to cancel it cancels this run as well
   * @param result of the tests, none of them red
   * @param progress is told while it runs
   */
  public MutationRun(
      TestSources files,
      TestRunner runner,
      SuiteResult result,
      MutationSettings settings,
      ProgressListener progress) {
    if (result.red()) {
      throw new IllegalArgumentException("mutation needs green tests");
    }
    this.files = files;
    this.runner = runner;
    this.settings = settings;
    this.progress = progress;
    result.results().forEach(each -> usual.put(name(each.id()), each));
  }

  private static String name(TestId id) {
    return id.file() + ":" + id.name();
  }

  /**
   * Tries mutants.
   *
   * @param coverage what the tests have reached
   */
  public MutationReport run(CoverageReport coverage) {
    List<Source> sources = new ArrayList<>();
    List<Chosen> candidates = new ArrayList<>();
    for (FileCoverage file : coverage.files()) {
      source(file.file())
          .ifPresent(
              source -> {
                candidates.addAll(candidates(sources.size(), source, file));
                sources.add(source);
              });
    }
    List<Chosen> chosen = chosen(candidates);
    AtomicReferenceArray<Mutant> mutants = new AtomicReferenceArray<>(chosen.size());
    tryAll(chosen, sources, mutants);
    List<List<Mutant>> byFile = new ArrayList<>();
    sources.forEach(_ -> byFile.add(new ArrayList<>()));
    int notRun = 0;
    for (int i = 0; i < chosen.size(); i++) {
      Mutant mutant = mutants.get(i);
      if (mutant == null) {
        notRun++;
      } else {
        byFile.get(chosen.get(i).file()).add(mutant);
      }
    }
    List<MutatedFile> mutated = new ArrayList<>();
    for (int i = 0; i < sources.size(); i++) {
      mutated.add(new MutatedFile(sources.get(i), byFile.get(i)));
    }
    return new MutationReport(mutated, candidates.size(), notRun);
  }

  /** The text of a program that is to be mutated: not of tests, and not a tree of PolyScope. */
  private Optional<Source> source(String name) {
    boolean wanted = settings.only().isEmpty() || settings.only().stream().anyMatch(name::contains);
    boolean test = usual.values().stream().anyMatch(each -> each.id().file().equals(name));
    if (!wanted || test || !(name.endsWith(SCRIPT) || name.endsWith(TREE))) {
      return Optional.empty();
    }
    try {
      return Optional.of(Source.of(name, files.read(name)));
    } catch (IOException e) {
      // it was there when the tests ran, and nobody can mutate what is gone
      return Optional.empty();
    }
  }

  private List<Chosen> candidates(int number, Source source, FileCoverage coverage) {
    Map<Integer, List<TestId>> covering = new HashMap<>();
    for (LineCoverage line : coverage.lines()) {
      covering.put(line.line(), orders.computeIfAbsent(line.tests(), this::inOrder));
    }
    List<Mutation> all =
        source.name().endsWith(TREE)
            ? TreeMutations.in(source, covering.keySet())
            : MutationFinder.in(source, StandardBuiltins.create());
    return all.stream()
        .map(each -> new Chosen(number, each, covering.getOrDefault(each.reach(), List.of())))
        .toList();
  }

  /** Those that run shortest first. */
  private List<TestId> inOrder(List<String> names) {
    return names.stream()
        .map(usual::get)
        .filter(each -> each != null && each.status() == TestStatus.PASSED)
        .sorted(
            Comparator.comparingDouble(TestResult::robotTimeS)
                .thenComparing(each -> name(each.id())))
        .map(TestResult::id)
        .toList();
  }

  private List<Chosen> chosen(List<Chosen> candidates) {
    if (settings.most() == 0 || candidates.size() <= settings.most()) {
      return candidates;
    }
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < candidates.size(); i++) {
      order.add(i);
    }
    Collections.shuffle(order, new Random(settings.seed()));
    Set<Integer> some = new HashSet<>(order.subList(0, settings.most()));
    List<Chosen> chosen = new ArrayList<>();
    for (int i = 0; i < candidates.size(); i++) {
      if (some.contains(i)) {
        chosen.add(candidates.get(i));
      }
    }
    return chosen;
  }

  private void tryAll(
      List<Chosen> chosen, List<Source> sources, AtomicReferenceArray<Mutant> mutants) {
    int jobs = Math.clamp(chosen.size(), 1, settings.jobs());
    AtomicInteger next = new AtomicInteger();
    Runnable worker =
        () -> {
          for (int i = next.getAndIncrement(); i < chosen.size(); i = next.getAndIncrement()) {
            if (runner.cancelled()) {
              return;
            }
            Chosen one = chosen.get(i);
            Mutant mutant = tried(one, sources.get(one.file()));
            // of a trial that was cut short nothing is known
            if (!runner.cancelled()) {
              mutants.set(i, mutant);
              tell(chosen.size());
            }
          }
        };
    try (ExecutorService workers = Executors.newFixedThreadPool(jobs)) {
      for (int i = 0; i < jobs; i++) {
        workers.execute(worker);
      }
    }
  }

  private synchronized void tell(int all) {
    tried++;
    progress.tried(tried, all);
  }

  private Mutant tried(Chosen one, Source source) {
    if (one.covering().isEmpty()) {
      return new Mutant(one.mutation(), MutantStatus.NOT_COVERED, List.of(), Optional.empty(), "");
    }
    List<TestTrial.Step> steps =
        one.covering().stream()
            .map(id -> new TestTrial.Step(id, usual.get(name(id)).robotTimeS()))
            .toList();
    TestRunner changed = runner.over(new ChangedFile(files, source, one.mutation()));
    return switch (new TestTrial(changed).run(steps)) {
      case TestTrial.Result.Green _ -> mutant(one, MutantStatus.SURVIVED, Optional.empty(), "");
      case TestTrial.Result.NoProgram(var why) ->
          mutant(one, MutantStatus.NOT_COMPILED, Optional.empty(), why);
      case TestTrial.Result.Red(var test) ->
          mutant(
              one,
              test.status() == TestStatus.TIMED_OUT ? MutantStatus.TIMED_OUT : MutantStatus.KILLED,
              Optional.of(test.id()),
              test.failure().map(TestFailure::message).orElse(""));
    };
  }

  private static Mutant mutant(
      Chosen one, MutantStatus status, Optional<TestId> killer, String reason) {
    return new Mutant(one.mutation(), status, one.covering(), killer, reason);
  }
}
