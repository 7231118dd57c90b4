package org.pendant.desktop.program.form;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;

/** A program without a screen around it. It remembers what it was told. */
final class FakeHost implements FormHost {
  private final ControllerState state;
  private final Deque<ProgramTree> past = new ArrayDeque<>();
  private final List<String> told = new ArrayList<>();
  private final List<NodeProblem> problems = new ArrayList<>();
  private final List<NodeProblem> warnings = new ArrayList<>();
  private Installation installation = Installation.NONE;
  private ProgramTree tree;
  private Runnable changed = () -> {};
  private PoseForm poseForm = PoseForm.STANDARD;

  FakeHost(ProgramTree tree, ControllerState state) {
    this.tree = tree;
    this.state = state;
  }

  void setInstallation(Installation other) {
    installation = other;
  }

  void setPoseForm(PoseForm other) {
    poseForm = other;
  }

  @Override
  public PoseForm poseForm() {
    return poseForm;
  }

  /** Runs {@code action} after each change, as the screen around would show the tree again. */
  void whenChanged(Runnable action) {
    changed = action;
  }

  void addProblem(NodeProblem problem) {
    problems.add(problem);
  }

  void addWarning(NodeProblem warning) {
    warnings.add(warning);
  }

  void undo() {
    tree = past.pop();
    changed.run();
  }

  /** What was done and asked, oldest first. */
  List<String> told() {
    return List.copyOf(told);
  }

  @Override
  public ProgramTree tree() {
    return tree;
  }

  @Override
  public Installation installation() {
    return installation;
  }

  @Override
  public ControllerState state() {
    return state;
  }

  @Override
  public void change(String what, ProgramTree next) {
    told.add(what);
    past.push(tree);
    tree = next;
    changed.run();
  }

  @Override
  public List<NodeProblem> problems(long key) {
    return problems.stream().filter(each -> each.key() == key).toList();
  }

  @Override
  public List<NodeProblem> warnings(long key) {
    return warnings.stream().filter(each -> each.key() == key).toList();
  }

  @Override
  public void select(long key) {
    told.add("select " + key);
  }

  @Override
  public void teach(String waypoint) {
    told.add("teach " + waypoint);
  }

  @Override
  public void holdToGo(String waypoint) {
    told.add("go " + waypoint);
  }

  @Override
  public void release() {
    told.add("release");
  }

  @Override
  public void notify(String text) {
    told.add(text);
  }
}
