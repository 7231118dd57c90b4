package org.pendant.kit.icon;

import com.formdev.flatlaf.extras.FlatSVGIcon;
import java.awt.Color;
import java.awt.Component;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.UIManager;
import org.pendant.kit.theme.Palette;

/**
 * Icon: a drawing in the colours of the theme, sharp at every scale. The drawing is an .svg file in
 * the light theme's colours of the {@link Palette}; its black, {@code #1D2329}, stands for the
 * colour of the text beside the icon. An icon of a disabled component is grey.
 */
@SuppressWarnings("serial") // never written to a stream
public final class SvgIcon extends FlatSVGIcon {
  private static final String FOLDER = "org/pendant/kit/icon/";
  private static final int TEXT = 0x1D2329;
  private static final int RGB = 0xFFFFFF;

  private final boolean lit;
  private final transient Optional<Color> color;

  private SvgIcon(FlatSVGIcon drawing, boolean lit, Optional<Color> color) {
    super(drawing);
    this.lit = lit;
    this.color = color;
    setColorFilter(new ColorFilter(this::shown));
  }

  /**
   * A drawing in its own colours.
   *
   * @param name of its file, without the ending, such as {@code glyph/play}
   * @param size of its sides, in pixels before scaling
   */
  public static SvgIcon of(String name, int size) {
    return of(name, size, size);
  }

  /** A drawing that is not a square, as {@link #of(String, int)}. */
  public static SvgIcon of(String name, int width, int height) {
    FlatSVGIcon drawing =
        new FlatSVGIcon(FOLDER + name + ".svg", width, height, SvgIcon.class.getClassLoader());
    return new SvgIcon(drawing, false, Optional.empty());
  }

  /** The same in one colour, which may be one of the {@link Palette} or what is selected. */
  public SvgIcon in(Color only) {
    return new SvgIcon(this, lit, Optional.of(only));
  }

  /** The same for what shows a state, and continues to show it while it is disabled. */
  public SvgIcon lit() {
    return new SvgIcon(this, true, color);
  }

  /**
   * What a colour of the drawing becomes. One that has become what it is may be asked for again.
   */
  @SuppressWarnings("ReferenceEquality") // the colour that was given, not one that looks like it
  private Color shown(Component on, Color drawn) {
    if (!lit && !on.isEnabled()) {
      return UIManager.getColor("Label.disabledForeground");
    }
    if (color.isPresent()) {
      return color.get();
    }
    Color text = on.getForeground();
    return drawn == text || (drawn.getRGB() & RGB) == TEXT ? text : Palette.ofLight(drawn);
  }

  /** The icon itself: it looks at whether its component is enabled. */
  @Override
  public Icon getDisabledIcon() {
    return this;
  }
}
