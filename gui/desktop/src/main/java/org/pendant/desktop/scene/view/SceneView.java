package org.pendant.desktop.scene.view;

import static org.pendant.desktop.scene.view.PictureTexts.text;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.geom.AffineTransform;
import java.awt.image.BufferedImage;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.DoubleConsumer;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.LongConsumer;
import java.util.function.UnaryOperator;
import javax.swing.JPanel;
import javax.swing.Timer;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.Camera;
import org.pendant.desktop.scene.Lens;
import org.pendant.desktop.scene.Picked;
import org.pendant.desktop.scene.SceneBounds;
import org.pendant.desktop.scene.SceneModel;
import org.pendant.desktop.scene.SceneTheme;
import org.pendant.desktop.scene.gl.OffscreenScene;
import org.pendant.desktop.scene.gl.Quality;
import org.pendant.desktop.scene.gl.SceneUnavailable;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.dock.Dockable;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.LookFollower;
import org.pendant.kit.theme.Palette;
import org.pendant.models.pose.Pose;

/**
 * Scene view: shows models in 3D. A lightweight component: pictures are drawn elsewhere ({@link
 * OffscreenScene}) at the pixels of the screen, and only when the model, the camera or the size has
 * changed. OpenGL is started when the component becomes part of a window; where there is none the
 * component says why.
 *
 * <p>Only the dispatch thread calls it.
 */
public final class SceneView extends JPanel implements LookFollower {
  private static final long serialVersionUID = 1L;

  /** Distance at which the tool fills a good part of the picture, as a share of the arm's reach. */
  private static final double TOOL_SHARE = 0.6;

  /** Pictures that are kept have so many times the pixels of the screen in a row. */
  private static final int PHOTO_FACTOR = 2;

  /** Nothing changed for this long: time to draw in full. */
  private static final int REST_MS = 150;

  private transient Optional<OffscreenScene> scene = Optional.empty();
  private transient Optional<PictureLoop> loop = Optional.empty();
  private transient Optional<SceneModel> model = Optional.empty();
  private Lens lens = Lens.PERSPECTIVE;
  private transient Optional<Camera> camera = Optional.empty();

  /** Whether all of the robot was asked for, and nobody has turned to anything else since. */
  private boolean whole;

  private transient Optional<BufferedImage> picture = Optional.empty();

  private final transient ArmDrag drag = new ArmDrag(this);
  private final transient ObjectDrag placing = new ObjectDrag(this);
  private final transient MarkMouse marks = new MarkMouse(this);
  private final transient HoverTracker hover =
      new HoverTracker(this::pick, EventQueue::invokeLater, this::repaint);
  private final Timer rest = Faults.timer(REST_MS, () -> loop.ifPresent(PictureLoop::settle));

  /** Counts the windows it was part of, so that what was started for an earlier one is dropped. */
  private int window;

  /** The last of these that OpenGL was started for. */
  private int begun;

  /** A view that shows nothing until {@link #setModel}. */
  public SceneView() {
    super(new BorderLayout());
    assert EventQueue.isDispatchThread();
    setName("scene");
    setFocusable(true);
    putClientProperty(Dockable.TAKES_KEYS, true);
    getAccessibleContext().setAccessibleName("3D view");
    getAccessibleContext().setAccessibleDescription(text("arrowsTurnTheViewShiftAnd"));
    addMouseListener(drag);
    addMouseMotionListener(drag);
    addMouseListener(placing);
    addMouseMotionListener(placing);
    CameraMouse mouse = new CameraMouse(this);
    addMouseListener(mouse);
    addMouseMotionListener(mouse);
    addMouseWheelListener(mouse);
    addMouseListener(marks);
    addMouseMotionListener(marks);
    addMouseListener(hover);
    addMouseMotionListener(hover);
    CameraKeys.bind(this);
    rest.setRepeats(false);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            hover.leave();
            marks.leave();
            if (whole) {
              fit();
            }
            want();
          }
        });
  }

  /** Shows this model from now on. Another arm than before is shown whole. */
  public void setModel(SceneModel next) {
    assert EventQueue.isDispatchThread();
    boolean otherArm =
        model.map(current -> !current.arm().id().equals(next.arm().id())).orElse(true);
    model = Optional.of(next);
    if (otherArm) {
      camera = Optional.empty();
    }
    want();
  }

  /** Looks at the robot from a standard direction, so that all of it is seen. */
  public void look(StandardView direction) {
    model.ifPresent(
        shown -> {
          setCamera(
              fitted(Camera.of(direction, SceneBounds.of(shown), aspect()).through(lens), shown));
          whole = true;
        });
  }

  /** How depth is shown. */
  public Lens lens() {
    return lens;
  }

  /** Shows depth in this way from now on. */
  public void setLens(Lens next) {
    assert EventQueue.isDispatchThread();
    lens = next;
    change(current -> current.through(next));
  }

  /** Whether pictures are drawn so fast that there may be more of them than of refreshes. */
  public boolean hasTime() {
    return loop.map(PictureLoop::hasTime).orElse(false);
  }

  /** What is shown, drawn anew as well as can be; nothing while nothing is shown. */
  public CompletableFuture<Optional<BufferedImage>> photo() {
    Optional<PictureRequest> drawn = loop.flatMap(PictureLoop::drawn);
    if (drawn.isEmpty() || scene.isEmpty()) {
      return CompletableFuture.completedFuture(Optional.empty());
    }
    PictureRequest shown = drawn.get();
    int factor =
        Math.min(PHOTO_FACTOR, OffscreenScene.MAX_PX / Math.max(shown.widthPx(), shown.heightPx()));
    BufferedImage into = OffscreenScene.image(factor * shown.widthPx(), factor * shown.heightPx());
    return scene
        .get()
        .draw(shown.model(), shown.camera(), Quality.FULL, into)
        .thenApply(Optional::of);
  }

  /** Shows all of the robot, from the same direction. */
  public void fit() {
    model.ifPresent(shown -> change(current -> fitted(current, shown)));
    whole = camera.isPresent();
  }

  /** Looks at the tool centre point from near by. */
  public void zoomToTool() {
    model.ifPresent(
        shown -> {
          Pose tcp = shown.tcpInBase();
          double distanceM = TOOL_SHARE * shown.arm().reachM();
          change(current -> current.zoomedTo(new Vector3(tcp.x(), tcp.y(), tcp.z()), distanceM));
        });
  }

  /** From where it is seen; empty until there is a model and a size. */
  public Optional<Camera> camera() {
    return camera;
  }

  /** Looks from there from now on. */
  public void setCamera(Camera next) {
    assert EventQueue.isDispatchThread();
    whole = false;
    camera = Optional.of(next);
    want();
  }

  /** Changes the camera, if there is one yet. */
  void change(UnaryOperator<Camera> step) {
    camera.ifPresent(current -> setCamera(step.apply(current)));
  }

  /** Pulls the arm from now on when it is dragged. */
  public void setHand(ArmHand hand) {
    assert EventQueue.isDispatchThread();
    drag.setHand(hand);
  }

  /** Places objects of the scene from now on when they are dragged. */
  public void setObjectHand(ObjectHand hand) {
    assert EventQueue.isDispatchThread();
    placing.setHand(hand);
  }

  /** Whether the pointer holds something, or will perhaps in a moment: the view does not turn. */
  boolean pointerTaken() {
    return drag.takesPointer() || placing.takesPointer();
  }

  /** Tells the key of a node of the program whose place or way people click. */
  public void onNode(LongConsumer listener) {
    marks.setListener(listener);
  }

  /** Tells the line of the program at which the tool was where people click. */
  public void onLine(IntConsumer listener) {
    marks.setLineListener(listener);
  }

  /** Tells when the tool was where people click, robot time, s. */
  public void onMoment(DoubleConsumer listener) {
    marks.setMomentListener(listener);
  }

  /** What lines of the program are called, such as {@code Line 12}. */
  public void setPlaces(IntFunction<String> names) {
    marks.setPlaces(names);
  }

  /** In which units people read what is written on the picture. */
  public void setForm(PoseForm form) {
    if (!form.equals(marks.form())) {
      marks.setForm(form);
      repaint();
    }
  }

  /** Chooses the node of the next stop of the program (1), or of the one before (-1). */
  void stepMark(int by) {
    marks.step(by);
  }

  /** What is on the screen. */
  Optional<PictureRequest> drawn() {
    return loop.flatMap(PictureLoop::drawn);
  }

  /** What is under a point of the component; nothing while nothing is shown. */
  public CompletableFuture<Optional<Picked>> pick(int x, int y) {
    Optional<PictureRequest> drawn = loop.flatMap(PictureLoop::drawn);
    if (drawn.isEmpty() || scene.isEmpty()) {
      return CompletableFuture.completedFuture(Optional.empty());
    }
    PictureRequest shown = drawn.get();
    return scene
        .get()
        .pick(shown.camera().ray(x + 0.5, y + 0.5, getWidth(), getHeight()), shown.model());
  }

  @Override
  public void addNotify() {
    super.addNotify();
    window++;
  }

  /**
   * Starts OpenGL for the window that this is in, after that has been painted: it needs both
   * processors.
   */
  private void begin() {
    if (begun != window) {
      begun = window;
      int startedFor = window;
      EventQueue.invokeLater(
          () -> Thread.ofVirtual().name("scene start").start(() -> start(startedFor)));
    }
  }

  @Override
  public void removeNotify() {
    window++;
    drag.release();
    placing.release();
    loop.ifPresent(PictureLoop::end);
    scene.ifPresent(SceneView::closeElsewhere);
    scene = Optional.empty();
    loop = Optional.empty();
    picture = Optional.empty();
    super.removeNotify();
  }

  /** Starts OpenGL; not on the dispatch thread, as that may take a second. */
  private void start(int startedFor) {
    try {
      OffscreenScene opened = OffscreenScene.open();
      EventQueue.invokeLater(() -> started(opened, startedFor));
    } catch (SceneUnavailable e) {
      EventQueue.invokeLater(() -> explain(Messages.shown(e.getMessage())));
    } catch (RuntimeException | Error fault) {
      EventQueue.invokeLater(() -> explain(text("anInternalError", fault)));
      Faults.report(fault);
    }
  }

  private void started(OffscreenScene opened, int startedFor) {
    if (startedFor != window) {
      closeElsewhere(opened);
      return;
    }
    scene = Optional.of(opened);
    loop =
        Optional.of(
            new PictureLoop(
                (request, into) ->
                    opened.draw(request.model(), request.camera(), request.quality(), into),
                EventQueue::invokeLater,
                System::nanoTime,
                image -> show(image, startedFor)));
    want();
  }

  private static void closeElsewhere(OffscreenScene scene) {
    Thread.ofVirtual().name("scene end").start(scene::close);
  }

  private void explain(String reason) {
    removeAll();
    add(new MissingGraphics(reason));
    revalidate();
    repaint();
  }

  private void show(BufferedImage image, int startedFor) {
    if (startedFor == window && hasColoursOfNow()) {
      picture = Optional.of(image);
      hover.look();
      marks.look();
      repaint();
    }
  }

  /** What was asked for before the colours changed may come after that. */
  private boolean hasColoursOfNow() {
    return drawn().map(each -> each.model().theme()).equals(model.map(SceneModel::theme));
  }

  /** The colours of the window. */
  public static SceneTheme colours() {
    return Palette.dark() ? SceneTheme.DARK : SceneTheme.LIGHT;
  }

  /** No picture is better than one in the other colours; the next one comes in a moment. */
  @Override
  public void lookChanged() {
    SceneTheme now = colours();
    model
        .filter(shown -> shown.theme() != now)
        .ifPresent(
            shown -> {
              picture = Optional.empty();
              setModel(shown.withTheme(now));
            });
  }

  private void want() {
    if (model.isEmpty() || getWidth() < 1 || getHeight() < 1) {
      return;
    }
    if (camera.isEmpty()) {
      look(StandardView.ISO);
      return;
    }
    AffineTransform device = device();
    int widthPx = pixels(getWidth() * device.getScaleX());
    int heightPx = pixels(getHeight() * device.getScaleY());
    PictureRequest request = new PictureRequest(model.get(), camera.get(), widthPx, heightPx);
    if (loop.isPresent() && loop.get().want(request)) {
      rest.restart();
    }
  }

  private AffineTransform device() {
    return getGraphicsConfiguration() == null
        ? new AffineTransform()
        : getGraphicsConfiguration().getDefaultTransform();
  }

  private static int pixels(double length) {
    return Math.clamp(Math.round(length), 1, OffscreenScene.MAX_PX);
  }

  /** Placed so that all of the robot is seen beside what is written over the picture. */
  private Camera fitted(Camera from, SceneModel shown) {
    Graphics graphics = getGraphics();
    if (graphics == null) {
      return from.fitted(SceneBounds.of(shown), aspect());
    }
    SceneOverlay overlay =
        new SceneOverlay((Graphics2D) graphics, getWidth(), getHeight(), marks.form());
    Camera fitted =
        from.fitted(
            SceneBounds.of(shown), aspect(), overlay.topShare(shown), overlay.bottomShare(shown));
    graphics.dispose();
    return fitted;
  }

  private double aspect() {
    return (double) Math.max(1, getWidth()) / Math.max(1, getHeight());
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    begin();
    if (picture.isEmpty()) {
      graphics.setColor(
          model.map(shown -> new Color(shown.theme().bottomRgb())).orElse(getBackground()));
      graphics.fillRect(0, 0, getWidth(), getHeight());
      return;
    }
    Graphics2D own = (Graphics2D) graphics.create();
    AffineTransform place = own.getTransform();
    // Pixel by pixel, whatever the scale of the screen.
    own.setTransform(
        AffineTransform.getTranslateInstance(place.getTranslateX(), place.getTranslateY()));
    own.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
    own.drawImage(
        picture.get(),
        0,
        0,
        pixels(getWidth() * place.getScaleX()),
        pixels(getHeight() * place.getScaleY()),
        null);
    own.dispose();
    write(graphics);
    want(); // on another screen there may be more pixels
  }

  private void write(Graphics graphics) {
    Optional<PictureRequest> drawn = loop.flatMap(PictureLoop::drawn);
    if (drawn.isEmpty()) {
      return;
    }
    Graphics2D own = (Graphics2D) graphics.create();
    SceneOverlay overlay = new SceneOverlay(own, getWidth(), getHeight(), marks.form());
    marks.finder().ifPresent(finder -> finder.chosenWays().forEach(overlay::mark));
    marks.target().ifPresent(overlay::mark);
    marks.setLabels(overlay.names(drawn.get()));
    overlay.legend(drawn.get().model());
    overlay.compared(drawn.get().model());
    overlay.doors(drawn.get().model());
    overlay.handles(placing.handles().values());
    overlay.pointed(hover.pointer(), marks.target().map(MarkTarget::words).or(hover::name));
    overlay.pointed(placing.pointer(), placing.words());
    drag.paint(own, drawn.get(), getWidth(), getHeight());
    own.dispose();
  }
}
