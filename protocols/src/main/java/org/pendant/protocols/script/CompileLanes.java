package org.pendant.protocols.script;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;

/**
 * Compile lanes: compile what clients send, in the order in which it came. Long texts have a lane
 * of their own, so that one client's does not hold up another's short one; both are platform
 * threads, as compiling computes without a pause and nests deeply. They end when there is nothing
 * to do.
 */
final class CompileLanes {
  /** Bytes of a text that takes about as long as clients notice. */
  private static final int LONG_TEXT = 1 << 18;

  private static final long IDLE_S = 10;

  private final Function<Source, LoadResult> compiler;
  private final Executor shortLane = lane("short scripts");
  private final Executor longLane = lane("long scripts");

  CompileLanes(Function<Source, LoadResult> compiler) {
    this.compiler = compiler;
  }

  private static Executor lane(String name) {
    ThreadPoolExecutor lane =
        new ThreadPoolExecutor(
            1,
            1,
            IDLE_S,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            Thread.ofPlatform().daemon().name("compiling " + name).factory());
    lane.allowCoreThreadTimeOut(true);
    return lane;
  }

  /** Waits until {@code source} is compiled. */
  LoadResult load(Source source) {
    Executor lane = source.text().length() > LONG_TEXT ? longLane : shortLane;
    return CompletableFuture.supplyAsync(() -> compiler.apply(source), lane).join();
  }
}
