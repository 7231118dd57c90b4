package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.List;
import java.util.function.IntFunction;
import org.pendant.desktop.lines.PathStrip;
import org.pendant.desktop.timeline.Pin;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.lines.RunProfile;

/**
 * Profile pins: the worst moments of a run for the timeline, and what their lines are called: only
 * those of the program that was started last may be nodes.
 */
record ProfilePins(PathStrip strip, LineNames names) {
  /** Those of a profile, one for each limit. */
  List<Pin> of(RunProfile profile) {
    IntFunction<String> place =
        profile.equals(strip.profile()) ? names::started : line -> text("line", line);
    return profile.worst().stream()
        .map(
            each ->
                new Pin(
                    each.worst().frame() * FrameTime.FRAME_S,
                    strip.words(each, place),
                    each.worst().used()))
        .toList();
  }
}
