package org.pendant.desktop.session;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneWriter;
import org.pendant.models.json.JsonMembers;

/**
 * Scene draft: a scene while people change it, with undo, and the document that it is written in.
 * It is around the arm only when it has been applied. One thread uses it, the dispatch thread.
 */
public final class SceneDraft {
  /** What a scene is called that was never saved. */
  public static final String UNTITLED = "untitled" + SceneFile.ENDING;

  private static final int MAX_UNDONE = 1000;

  private final List<Runnable> listeners = new ArrayList<>();
  private final Deque<Content> done = new ArrayDeque<>();
  private final Deque<Content> undone = new ArrayDeque<>();
  private final ProgramDocument.Listener follower = new Follower();
  private ProgramDocument document =
      ProgramDocument.untitled(UNTITLED, SceneWriter.write(Scene.EMPTY));

  /** Where a row of changes began that is undone as one. */
  private Optional<Content> row = Optional.empty();

  private Content saved = Content.EMPTY;
  private Content now = Content.EMPTY;
  private Read read = Read.NOTHING;

  /** The meshes of arms that have a tool of their own, which is not to be edited here. */
  private List<MeshPart> ofArms = List.of();

  /**
   * What the file says.
   *
   * @param equipment the members for devices and rules, by key, as JSON
   */
  private record Content(Scene scene, Map<String, String> equipment) {
    static final Content EMPTY = new Content(Scene.EMPTY, Map.of());

    static Content of(Scene scene, String text) {
      Map<String, String> members = new LinkedHashMap<>(JsonMembers.of(text));
      members.keySet().removeAll(SceneWriter.KEYS);
      return new Content(scene, members);
    }

    String text() {
      return SceneWriter.write(scene, equipment);
    }

    Content with(UnaryOperator<Scene> as) {
      return new Content(as.apply(scene), equipment);
    }
  }

  /** Devices, and what says so. */
  private record Read(Content content, List<String> controllers, List<List<DeviceSetup>> devices) {
    static final Read NOTHING = new Read(Content.EMPTY, List.of(), List.of());

    static Read of(Content content, List<MeshPart> ofArms) {
      try {
        CellPlan plan =
            SceneFile.of("scene", content.text(), MeshFiles.of(content.scene(), ofArms)).plan();
        return new Read(
            content,
            plan.layout().names(),
            plan.equipment().devices().stream().map(CellEquipment::devices).toList());
      } catch (IOException e) {
        throw new IllegalStateException("a draft has devices that cannot be", e);
      }
    }
  }

  /** Empty space. */
  public SceneDraft() {
    document.addListener(follower);
  }

  /** Hears when the document has been saved. */
  private final class Follower implements ProgramDocument.Listener {
    @Override
    public void fileChanged() {
      if (!document.modified()) {
        saved = now;
      }
      tell();
    }
  }

  /** The scene as people have it now. */
  public Scene scene() {
    return now.scene();
  }

  /** The meshes that it has, with those of tools of arms. */
  public MeshFiles meshes() {
    return MeshFiles.of(scene(), ofArms);
  }

  /** The meshes of arms that have a tool of their own. */
  public List<MeshPart> meshesOfArms() {
    return ofArms;
  }

  /** The members for devices and rules, by key, as JSON. */
  public Map<String, String> equipment() {
    return Collections.unmodifiableMap(now.equipment());
  }

  /** What the members for devices say of each controller; of one where it is alone. */
  public List<List<DeviceSetup>> devices() {
    return read().devices();
  }

  /** The names of the controllers; none where one is alone. */
  public List<String> controllers() {
    return read().controllers();
  }

  private Read read() {
    if (!read.content().equals(now)) {
      read = Read.of(now, ofArms);
    }
    return read;
  }

  /** Where it is written: a file, or a text without one. */
  public ProgramDocument document() {
    return document;
  }

  /** Takes another scene in place of this one, which cannot be undone. */
  public void open(SceneFile other) {
    Optional<SavedProgram> disk =
        other.onDisk().filter(saved -> !saved.text().equals(other.text()));
    if (disk.isPresent()) {
      restore(ProgramDocument.of(disk.get()), other.scene(), other);
      return;
    }
    open(
        other
            .onDisk()
            .map(ProgramDocument::of)
            .orElseGet(
                () ->
                    ProgramDocument.untitled(
                        other.isNone() ? UNTITLED : other.name(), other.text())),
        other.scene(),
        other.plan());
  }

  /**
   * Takes a document.
   *
   * @param wanted what it says, which is a scene
   * @param plan that has the arms of its cell
   */
  private void open(ProgramDocument other, Scene wanted, CellPlan plan) {
    ofArms = plan.meshesOfArms();
    document.removeListener(follower);
    document = other;
    document.addListener(follower);
    done.clear();
    undone.clear();
    saved = Content.of(wanted, other.text());
    now = saved;
    tell();
  }

  /**
   * Takes a scene that was not saved.
   *
   * @param other as it is on disk
   * @param onDisk what that says
   * @param left what was not saved
   */
  public void restore(ProgramDocument other, Scene onDisk, SceneFile left) {
    open(other, onDisk, left.plan());
    done.push(now);
    now = Content.of(left.scene(), left.text());
    document.setText(left.text());
    tell();
  }

  /** Makes a change. */
  public void set(Scene next) {
    set(next, now.equipment());
  }

  /**
   * Makes a change of both.
   *
   * @param members for devices and rules, by key, as JSON that such a scene may have
   */
  public void set(Scene next, Map<String, String> members) {
    change(new Content(next, new LinkedHashMap<>(members)));
  }

  /**
   * Takes other devices and rules.
   *
   * @param members by key, as JSON that a scene may have
   */
  public void setEquipment(Map<String, String> members) {
    change(new Content(now.scene(), new LinkedHashMap<>(members)));
  }

  /**
   * Has the scene, and all that can be undone, as another one that is the same thing: one that was
   * saved in another folder, from where its meshes are named otherwise. Nothing of this can be
   * undone.
   */
  public void rename(UnaryOperator<Scene> as) {
    rename(done, as);
    rename(undone, as);
    row = row.map(each -> each.with(as));
    now = now.with(as);
    document.setText(now.text());
    saved = document.modified() ? saved.with(as) : now;
    tell();
  }

  private static void rename(Deque<Content> contents, UnaryOperator<Scene> as) {
    List<Content> renamed = contents.stream().map(each -> each.with(as)).toList();
    contents.clear();
    contents.addAll(renamed);
  }

  private void change(Content next) {
    if (next.equals(now)) {
      return;
    }
    if (row.isEmpty() || done.isEmpty() || !done.getFirst().equals(row.get())) {
      done.push(now);
    }
    if (done.size() > MAX_UNDONE) {
      done.removeLast();
    }
    undone.clear();
    show(next);
  }

  /** Has all changes until {@link #endRow} undone as one. */
  public void beginRow() {
    row = Optional.of(now);
  }

  /** Has changes undone one by one. */
  public void endRow() {
    row = Optional.empty();
  }

  public boolean canUndo() {
    return !done.isEmpty();
  }

  public boolean canRedo() {
    return !undone.isEmpty();
  }

  /** Takes the last change back. */
  public void undo() {
    turn(done, undone);
  }

  /** Makes again the change that was taken back last. */
  public void redo() {
    turn(undone, done);
  }

  private void turn(Deque<Content> from, Deque<Content> to) {
    if (!from.isEmpty()) {
      to.push(now);
      show(from.pop());
    }
  }

  private void show(Content next) {
    now = next;
    // what is on disk may be written another way: who is back there has nothing to save
    Optional<String> onDisk =
        next.equals(saved) ? document.onDisk().map(SavedProgram::text) : Optional.empty();
    document.setText(onDisk.orElseGet(next::text));
    tell();
  }

  /** Tells {@code listener} of every change, and of every save, from now on. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }
}
