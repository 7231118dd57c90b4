package org.pendant.project.program;

import java.util.List;
import org.pendant.project.program.TemplateStep.Seek;

/** Seek change: a seek with one of its many components changed. */
public record SeekChange(Seek was) {
  /** Takes items from the stack, or puts them on it. */
  public Seek destack(boolean destack) {
    return new Seek(
        destack,
        was.name(),
        was.start(),
        was.feature(),
        was.direction(),
        was.limitM(),
        was.itemHeightM(),
        was.found(),
        was.speedMPerS(),
        was.accelerationMPerS2());
  }

  /** Called otherwise. */
  public Seek name(String name) {
    return place(name, was.start(), was.feature(), was.direction());
  }

  /** Begins at another place. */
  public Seek start(String start) {
    return place(was.name(), start, was.feature(), was.direction());
  }

  /** Along the axes of another feature. */
  public Seek feature(String feature) {
    return place(was.name(), was.start(), feature, was.direction());
  }

  /** In another direction. */
  public Seek direction(List<Double> direction) {
    return place(was.name(), was.start(), was.feature(), direction);
  }

  private Seek place(String name, String start, String feature, List<Double> direction) {
    return new Seek(
        was.destack(),
        name,
        start,
        feature,
        direction,
        was.limitM(),
        was.itemHeightM(),
        was.found(),
        was.speedMPerS(),
        was.accelerationMPerS2());
  }

  /** With another farthest way and thickness of items, m. */
  public Seek lengths(double limitM, double itemHeightM) {
    return way(limitM, itemHeightM, was.found(), was.speedMPerS(), was.accelerationMPerS2());
  }

  /** With another expression for an item that is found. */
  public Seek found(String found) {
    return way(was.limitM(), was.itemHeightM(), found, was.speedMPerS(), was.accelerationMPerS2());
  }

  /** With another speed and acceleration. */
  public Seek motion(double speedMPerS, double accelerationMPerS2) {
    return way(was.limitM(), was.itemHeightM(), was.found(), speedMPerS, accelerationMPerS2);
  }

  private Seek way(
      double limitM,
      double itemHeightM,
      String found,
      double speedMPerS,
      double accelerationMPerS2) {
    return new Seek(
        was.destack(),
        was.name(),
        was.start(),
        was.feature(),
        was.direction(),
        limitM,
        itemHeightM,
        found,
        speedMPerS,
        accelerationMPerS2);
  }
}
