package org.pendant.desktop.timeline;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.pendant.recording.lines.RunProfile;

/** Pins: the worst moments of the last run, of the robot or of the file that is looked at. */
final class Pins {
  private final LookBack lookBack;
  private Supplier<RunProfile> live = () -> RunProfile.NONE;
  private Function<RunProfile, List<Pin>> words = profile -> List.of();
  private RunProfile ofFile = RunProfile.NONE;
  private RunProfile shown = RunProfile.NONE;
  private List<Pin> pins = List.of();

  Pins(LookBack lookBack) {
    this.lookBack = lookBack;
  }

  /**
   * Takes them from here.
   *
   * @param profile of the last run of the robot
   * @param texts what the worst moments of a profile are called
   */
  void from(Supplier<RunProfile> profile, Function<RunProfile, List<Pin>> texts) {
    live = profile;
    words = texts;
  }

  /** A file is looked at from now on. */
  void setFile(RunProfile profile) {
    ofFile = profile;
  }

  /** Those of which the moment is still kept, in the order of time. */
  List<Pin> all() {
    RunProfile now = lookBack.ofFile() ? ofFile : live.get();
    if (!now.equals(shown)) {
      shown = now;
      pins = words.apply(now).stream().sorted(Comparator.comparingDouble(Pin::timeS)).toList();
    }
    double firstS = lookBack.recording().firstS();
    return pins.stream().filter(each -> each.timeS() >= firstS).toList();
  }

  /** The one nearest to a time, if it is as near as that. */
  Optional<Pin> at(double timeS, double nearS) {
    return all().stream()
        .filter(each -> Math.abs(each.timeS() - timeS) <= nearS)
        .min(Comparator.comparingDouble(each -> Math.abs(each.timeS() - timeS)));
  }

  /** The next one after a time, or the last one before. */
  Optional<Pin> next(double timeS, boolean forward) {
    double rounding = 1e-6;
    return forward
        ? all().stream().filter(each -> each.timeS() > timeS + rounding).findFirst()
        : all().reversed().stream().filter(each -> each.timeS() < timeS - rounding).findFirst();
  }
}
