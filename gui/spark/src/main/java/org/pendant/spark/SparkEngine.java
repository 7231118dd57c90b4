package org.pendant.spark;

import static org.pendant.spark.SparkTexts.text;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.LongStream;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.engine.ResultSink;
import org.pendant.sweep.engine.VariantSource;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.run.SweepResult;

/**
 * Spark engine: variants run in the executors of a Spark application.
 *
 * <p>Variants go out in slices, a Spark job each, of chunks, a task each. A few slices are under
 * way at a time, so that workers have something to do while the last task of one is still running;
 * results are taken slice by slice, so that they come in order and memory stays the same however
 * many there are. Chunks are made as long as a worker needs about a second for: Spark takes
 * milliseconds to start one.
 *
 * <p>A worker that dies has its tasks run again by others. When a task of a slice has failed more
 * often than {@code spark.task.maxFailures}, its chunks become jobs of their own, and the variants
 * of those that fail again run one at a time, so that one that brings down every worker costs
 * nothing but its own result.
 */
final class SparkEngine implements Engine {
  private static final int SLICES_UNDER_WAY = 3;
  private static final int CHUNKS_PER_CORE = 2;
  private static final long CHUNK_NS = TimeUnit.SECONDS.toNanos(1);
  private static final int MAX_CHUNK = 4096;

  /** About 25 MB of answers; enough for some 16 runs in each chunk of a thousand cores. */
  private static final int MAX_SLICE = 32_768;

  private final JavaSparkContext context;
  private final Broadcast<WorkerJob> job;

  /** Variants in a chunk; the results of those before tell how long they take. */
  private int chunkSize;

  /** A slice that is under way. */
  private record Slice(List<Chunk> chunks, ChunkAnswers answers) {
    Slice {
      chunks = List.copyOf(chunks);
    }

    /** Number after that of its last variant. */
    long end() {
      return chunks.getLast().variants().getLast().number() + 1;
    }
  }

  /**
   * An engine.
   *
   * @param context is closed with it, but not when it cannot be made
   * @throws EngineException if workers do not start, or cannot use the job
   */
  SparkEngine(JavaSparkContext context, WorkerJob job) throws EngineException {
    this.context = context;
    this.job = context.broadcast(job);
    // What no worker can do, such as reading classes of a newer Java, would fail for every variant.
    if (submit(List.of(new Chunk(List.of()))).await(() -> false)
        instanceof ChunkAnswers.Outcome.Failed(var cause)) {
      throw new EngineException(text("workersCannotRunVariants", firstLine(cause)), cause);
    }
  }

  @Override
  public String description() {
    return text("sparkAt", context.version(), context.master(), cores());
  }

  /** Of the executors that there are now: they come and go. */
  private int cores() {
    return Math.max(1, context.defaultParallelism());
  }

  @Override
  public long run(
      VariantSource variants, long first, long end, ResultSink sink, BooleanSupplier stopped)
      throws IOException, EngineException {
    Deque<Slice> slices = new ArrayDeque<>();
    long done = first;
    chunkSize = 1;
    try {
      while (done < end && !stopped.getAsBoolean()) {
        long begun = slices.isEmpty() ? done : slices.getLast().end();
        while (begun < end && slices.size() < SLICES_UNDER_WAY) {
          List<Chunk> chunks = chunks(variants, begun, end);
          slices.add(new Slice(chunks, submit(chunks)));
          begun = slices.getLast().end();
        }
        Slice slice = slices.remove();
        List<SweepResult> results =
            switch (slice.answers().await(stopped)) {
              case ChunkAnswers.Outcome.Answered(var answers) -> results(slice.chunks(), answers);
              case ChunkAnswers.Outcome.Cancelled _ -> List.of();
              case ChunkAnswers.Outcome.Failed _ -> {
                // the slices behind may have failed by the same variant, and run again later
                cancel(slices);
                yield resultsOfEach(slice.chunks(), stopped);
              }
            };
        for (SweepResult each : results) {
          sink.take(each);
          done++;
        }
      }
      return done;
    } catch (EngineException e) {
      // Ctrl-C ends Spark as well, and Spark may be the first to hear of it
      if (stopped.getAsBoolean()) {
        return done;
      }
      throw e;
    } finally {
      cancel(slices);
    }
  }

  private static void cancel(Deque<Slice> slices) {
    slices.forEach(each -> each.answers().cancel());
    slices.clear();
  }

  /** The chunks of the next slice. */
  private List<Chunk> chunks(VariantSource variants, long first, long end) {
    int tasks = cores() * CHUNKS_PER_CORE;
    long share = Math.min(MAX_SLICE, end - first) / tasks + 1;
    long size = Math.min(chunkSize, share);
    long last = Math.min(end, first + Math.min(MAX_SLICE, tasks * size));
    List<Chunk> chunks = new ArrayList<>();
    for (long at = first; at < last; at += size) {
      chunks.add(
          new Chunk(
              LongStream.range(at, Math.min(last, at + size))
                  .mapToObj(variants::variant)
                  .toList()));
    }
    return chunks;
  }

  private ChunkAnswers submit(List<Chunk> chunks) throws EngineException {
    try {
      return new ChunkAnswers(
          context
              .parallelize(chunks.stream().map(Chunk::bytes).toList(), chunks.size())
              .map(new RunChunk(job))
              .collectAsync());
    } catch (IllegalStateException e) {
      throw new EngineException(text("sparkHasEnded", firstLine(e)), e);
    }
  }

  private List<SweepResult> results(List<Chunk> chunks, List<byte[]> answers)
      throws EngineException {
    List<SweepResult> results = new ArrayList<>();
    long durationNs = 0;
    try {
      for (int i = 0; i < chunks.size(); i++) {
        Chunk.Results each = chunks.get(i).results(answers.get(i));
        results.addAll(each.results());
        durationNs += each.durationNs();
      }
    } catch (IOException e) {
      throw new EngineException(text("answerIsNoResult", e.getMessage()), e);
    }
    long perRunNs = Math.max(1, durationNs / results.size());
    // at most twice as long as the last: the first runs of a worker are slower than those that
    // follow
    chunkSize = (int) Math.clamp(CHUNK_NS / perRunNs, 1, Math.min(MAX_CHUNK, 2L * chunkSize));
    return results;
  }

  /**
   * The results of chunks some of which no worker brings to their end; those of the first ones when
   * the sweep is to end.
   */
  private List<SweepResult> resultsOfEach(List<Chunk> chunks, BooleanSupplier stopped)
      throws EngineException {
    List<ChunkAnswers> answers = new ArrayList<>();
    for (Chunk each : chunks) {
      answers.add(submit(List.of(each)));
    }
    List<ChunkAnswers.Outcome> outcomes = new ArrayList<>();
    for (ChunkAnswers each : answers) {
      outcomes.add(each.await(stopped));
    }
    List<SweepResult> results = new ArrayList<>();
    for (int i = 0; i < chunks.size() && !stopped.getAsBoolean(); i++) {
      Chunk chunk = chunks.get(i);
      switch (outcomes.get(i)) {
        case ChunkAnswers.Outcome.Answered(var answered) ->
            results.addAll(results(List.of(chunk), answered));
        case ChunkAnswers.Outcome.Failed _ -> results.addAll(oneAtATime(chunk, stopped));
        case ChunkAnswers.Outcome.Cancelled _ -> {
          return results;
        }
      }
    }
    return results;
  }

  /** The results of a chunk while nothing else runs, so that only one's own fault is counted. */
  private List<SweepResult> oneAtATime(Chunk chunk, BooleanSupplier stopped)
      throws EngineException {
    List<SweepResult> results = new ArrayList<>();
    for (SweepVariant each : chunk.variants()) {
      Chunk alone = new Chunk(List.of(each));
      switch (submit(List.of(alone)).await(stopped)) {
        case ChunkAnswers.Outcome.Answered(var answers) ->
            results.addAll(results(List.of(alone), answers));
        case ChunkAnswers.Outcome.Failed(var cause) ->
            results.add(SweepJob.lost(each, text("noWorkerBringsItToItsEnd", firstLine(cause))));
        case ChunkAnswers.Outcome.Cancelled _ -> {
          return results;
        }
      }
    }
    return results;
  }

  /** Of what Spark says; the rest is stacks. */
  private static String firstLine(Throwable cause) {
    return String.valueOf(cause.getMessage()).lines().findFirst().orElse("");
  }

  @Override
  public void close() {
    context.close();
  }
}
