package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import javax.swing.JComponent;
import org.pendant.controller.world.LinkContact;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;

/** Links card: whether links of the arm stop at what they get into. */
final class LinksCard {
  private final SceneDraft draft;
  private final TitledCard card =
      new TitledCard("links-of-the-arm", text("linksOfTheArm"), "[grow, fill]");
  private final PartsForm<Scene> form;

  LinksCard(SceneDraft draft) {
    this.draft = draft;
    form =
        new PartsForm<>(
            "cell-links",
            next -> SceneRefusal.of(() -> next, draft, draft.equipment()),
            draft::set);
    form.check(
        "stop-at-what-they-hit",
        text("stopAtWhatTheyHit"),
        scene -> scene.links() == LinkContact.STOP,
        (scene, stop) -> scene.withLinks(stop ? LinkContact.STOP : LinkContact.PASS));
    form.note(text("aLinkThatGetsIntoAn"));
    card.add(form.component());
  }

  JComponent component() {
    return card;
  }

  /** Shows the draft. */
  void show() {
    form.show(draft.scene());
  }
}
