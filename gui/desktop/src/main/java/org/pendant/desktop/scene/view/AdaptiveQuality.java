package org.pendant.desktop.scene.view;

import java.util.Arrays;
import java.util.List;
import org.pendant.desktop.scene.gl.Quality;

/**
 * Adaptive quality: chooses how well pictures that follow each other are drawn, from how long the
 * last ones took: as well as leaves about 30 of them in a second. Worse at once, better only after
 * a while, so that the look does not flicker.
 */
final class AdaptiveQuality {
  /** What a picture may take, ns. */
  private static final double BUDGET_NS = 33e6;

  /** What is better than now must fit well. */
  private static final double SPARE = 0.75;

  /** So many pictures in a row must say that there is time for a better one. */
  private static final int PATIENCE = 20;

  /** The median of so many counts: a hiccup changes nothing. */
  private static final int REMEMBERED = 5;

  private static final List<Quality> BEST_FIRST = List.of(Quality.values());

  private final double[] fullNs = new double[REMEMBERED];
  private int count;
  private Quality quality = Quality.FULL;
  private int couldBeBetter;

  /** How well to draw what moves. */
  Quality quality() {
    return quality;
  }

  /** A picture took this long, ns. */
  void took(Quality drawn, double ns) {
    fullNs[count++ % REMEMBERED] = ns / share(drawn);
    double typicalNs = typicalNs();
    Quality fitting = fitting(typicalNs, BUDGET_NS);
    if (fitting.compareTo(quality) > 0) {
      quality = fitting;
      couldBeBetter = 0;
      return;
    }
    Quality better = fitting(typicalNs, SPARE * BUDGET_NS);
    couldBeBetter = better.compareTo(quality) < 0 ? couldBeBetter + 1 : 0;
    if (couldBeBetter >= PATIENCE) {
      quality = BEST_FIRST.get(BEST_FIRST.indexOf(quality) - 1);
      couldBeBetter = 0;
    }
  }

  /** Another size has other times. */
  void forget() {
    count = 0;
    couldBeBetter = 0;
  }

  private static Quality fitting(double ofFullNs, double budgetNs) {
    for (Quality each : BEST_FIRST) {
      if (share(each) * ofFullNs <= budgetNs) {
        return each;
      }
    }
    return BEST_FIRST.getLast();
  }

  /** What a picture takes as a share of the best, measured without a GPU. */
  private static double share(Quality quality) {
    return switch (quality) {
      case FULL -> 1;
      case SMOOTH -> 0.65;
      case SWIFT -> 0.28;
      case HALF -> 0.16;
    };
  }

  private double typicalNs() {
    double[] known = Arrays.copyOf(fullNs, Math.min(count, REMEMBERED));
    Arrays.sort(known);
    return known[(known.length - 1) / 2];
  }
}
