package org.pendant.desktop.shell;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.IntFunction;
import org.pendant.desktop.lines.PathStrip;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.timeline.Pin;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.lines.RunProfile;

/**
 * Profile pins: the worst moments of a run for the timeline, and what their lines are called.
 *
 * @param programs the open program that ran at a time of a file that people look at
 */
record ProfilePins(
    PathStrip strip, LineNames names, DoubleFunction<Optional<ProgramDocument>> programs) {
  /** Those of a profile, one for each limit. */
  List<Pin> of(RunProfile profile) {
    boolean last = profile.equals(strip.profile());
    return profile.worst().stream()
        .map(each -> pin(each, each.worst().frame() * FrameTime.FRAME_S, last))
        .toList();
  }

  private Pin pin(RunProfile.Moment moment, double timeS, boolean last) {
    IntFunction<String> place =
        last ? names::started : line -> names.of(programs.apply(timeS), line);
    return new Pin(timeS, strip.words(moment, place), moment.worst().used());
  }
}
