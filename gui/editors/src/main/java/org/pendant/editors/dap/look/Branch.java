package org.pendant.editors.dap.look;

import static org.pendant.editors.dap.look.LookTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;

/** Branch: parts of a value, or variables that belong together. They are made when asked for. */
public interface Branch {
  /** The most parts that are made at once. */
  int MOST = 1000;

  /** How many parts there are. */
  int size();

  /** Whether the parts have numbers and no names. */
  boolean indexed();

  /**
   * Some of the parts; fails with {@link IllegalArgumentException} where they cannot be had any
   * more.
   *
   * @param start number of the first, from 0
   * @param count how many, 1 to {@link #MOST}; fewer come at the end
   */
  CompletableFuture<List<Shown>> page(int start, int count);

  /**
   * Changes a part; what it is then. Fails with the reason.
   *
   * @param name of the part
   * @param value an expression, as people write it
   */
  default CompletableFuture<Shown> assign(String name, String value) {
    return CompletableFuture.failedFuture(
        new IllegalArgumentException(text("notChangeableHere", name)));
  }

  /** The name by which data breakpoints know a part; empty where they cannot watch it. */
  default Optional<String> watchable(String name) {
    return Optional.empty();
  }

  /** Of parts that are there already. */
  static Branch of(List<Shown> parts, boolean indexed) {
    return of(parts, indexed, name -> Optional.empty());
  }

  /**
   * Of parts that are there already.
   *
   * @param watchable names of them for data breakpoints
   */
  static Branch of(
      List<Shown> parts, boolean indexed, Function<String, Optional<String>> watchable) {
    List<Shown> all = List.copyOf(parts);
    return new Branch() {
      @Override
      public int size() {
        return all.size();
      }

      @Override
      public boolean indexed() {
        return indexed;
      }

      @Override
      public CompletableFuture<List<Shown>> page(int start, int count) {
        return CompletableFuture.completedFuture(cut(all, start, count));
      }

      @Override
      public Optional<String> watchable(String name) {
        return watchable.apply(name);
      }
    };
  }

  /** The parts from {@code start}, {@code count} at most. */
  static <T> List<T> cut(List<T> all, int start, int count) {
    int from = Math.min(start, all.size());
    return all.subList(from, (int) Math.min((long) from + count, all.size()));
  }
}
