package org.pendant.desktop.move;

import java.util.Optional;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.settings.Settings;
import org.pendant.models.pose.Pose;

/**
 * Frame presenter: a frame of the user's own: typed, or taught by the TCP; kept for the next start.
 */
final class FramePresenter {
  private static final String KEY = "move.frame";

  private final Settings settings;
  private final Draft draft;
  private PoseForm form;
  private Pose inBase;

  /** As it was left. */
  FramePresenter(Settings settings, PoseForm form) {
    this.settings = settings;
    this.form = form;
    draft = new Draft(form.units(), (index, value) -> Optional.empty());
    inBase =
        settings
            .get(KEY)
            .flatMap(text -> SavedNumbers.read(text, Pose.SIZE))
            .map(Pose::of)
            .orElse(Pose.ZERO);
    show();
  }

  private void show() {
    draft.reset();
    draft.follow(form.numbers(inBase));
  }

  /** Its pose in the base. */
  Pose inBase() {
    return inBase;
  }

  /** It is somewhere else from now on, also after the next start. */
  void set(Pose poseInBase) {
    inBase = poseInBase;
    settings.put(KEY, SavedNumbers.text(poseInBase.toArray()));
    show();
  }

  /** It is where the user has typed. */
  void setTyped() {
    if (draft.edited() && draft.valid()) {
      set(form.pose(draft.values()));
    }
  }

  void setForm(PoseForm other) {
    draft.convert(other.units(), other.numbers(form.pose(draft.values())));
    form = other;
  }

  /** The pose in the base as it is shown and typed. */
  Draft draft() {
    return draft;
  }
}
