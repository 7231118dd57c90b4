package org.pendant.spark;

import static org.pendant.spark.SparkTexts.text;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import org.apache.spark.api.java.JavaFutureAction;
import org.pendant.sweep.engine.EngineException;

/** What the chunks of a job of Spark will answer. */
final class ChunkAnswers {
  private static final long LOOK_MS = 50;

  private final JavaFutureAction<List<byte[]>> answers;

  ChunkAnswers(JavaFutureAction<List<byte[]>> answers) {
    this.answers = answers;
  }

  /** What came of the job. */
  sealed interface Outcome {
    /** What each chunk answered, in their order. */
    record Answered(List<byte[]> answers) implements Outcome {
      public Answered {
        answers = List.copyOf(answers);
      }
    }

    /** A task failed more often than is allowed. */
    record Failed(Throwable cause) implements Outcome {}

    /** The sweep is to end. */
    record Cancelled() implements Outcome {}
  }

  /** Waits until the job is over or the sweep is to end, which cancels it. */
  Outcome await(BooleanSupplier stopped) throws EngineException {
    while (!stopped.getAsBoolean()) {
      try {
        return new Outcome.Answered(answers.get(LOOK_MS, TimeUnit.MILLISECONDS));
      } catch (TimeoutException e) {
        // still under way
      } catch (ExecutionException e) {
        if (!stopped.getAsBoolean()) {
          return new Outcome.Failed(e.getCause());
        }
      } catch (CancellationException e) {
        return new Outcome.Cancelled();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        throw new EngineException(text("interrupted"), e);
      }
    }
    cancel();
    return new Outcome.Cancelled();
  }

  /** Has workers give it up. */
  void cancel() {
    answers.cancel(true);
  }
}
