package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.Joints;
import org.pendant.project.installation.text.InstallationText;

final class ActiveInstallationTest {
  private static final Installation MOVED = Installation.NONE.withHome(Joints.ZERO);

  private final ActiveInstallation active = new ActiveInstallation();
  private final List<Installation> heard = new ArrayList<>();

  private static ProgramDocument document(String text) {
    return ProgramDocument.of(SavedProgram.create(Path.of("cell.pinst"), text));
  }

  @Test
  void aChangeIsWrittenIntoTheDocument() {
    active.addListener(() -> heard.add(active.current()));
    active.set(MOVED);
    assertEquals(InstallationText.write(MOVED), active.document().text());
    assertTrue(active.document().modified());
    assertEquals(List.of(MOVED), heard);
  }

  @Test
  void aDocumentThatIsReadAgainIsSetUp() {
    active.open(document(InstallationText.write(Installation.NONE)));
    active.addListener(() -> heard.add(active.current()));
    active
        .document()
        .reloaded(SavedProgram.create(Path.of("cell.pinst"), InstallationText.write(MOVED)));
    assertEquals(List.of(MOVED), heard);
    assertFalse(active.document().modified());
  }

  @Test
  void whoIsBackAtWhatIsOnDiskHasNothingToSaveHoweverItIsWritten() {
    String byHand = InstallationText.write(MOVED).replaceFirst("\n", "\n\n");
    active.open(document(byHand));
    assertEquals(MOVED, active.current());
    active.set(Installation.NONE);
    assertTrue(active.document().modified());
    active.set(MOVED);
    assertEquals(byHand, active.document().text());
    assertFalse(active.document().modified());
  }

  @Test
  void aTextThatIsNoInstallationChangesNothingAndIsTold() {
    active.open(document(InstallationText.write(MOVED)));
    active.document().setText("pendant installation 1\nnonsense\n");
    assertEquals(MOVED, active.current());
    assertTrue(active.problem().startsWith("cell.pinst:2:"), active.problem());
    active.set(Installation.NONE);
    assertEquals("", active.problem());
  }

  @Test
  void whatTheControllerBeganWithIsNothingToSave() {
    active.begin(MOVED);
    assertEquals(MOVED, active.current());
    assertFalse(active.document().modified());
  }

  @Test
  void anotherDocumentIsFollowedInsteadOfTheFirst() {
    ProgramDocument first = document(InstallationText.write(Installation.NONE));
    active.open(first);
    active.open(document(InstallationText.write(MOVED)));
    first.setText(InstallationText.write(Installation.NONE) + "robot id=\"ur10e\"\n");
    assertEquals(MOVED, active.current());
  }
}
