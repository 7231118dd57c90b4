/**
 * Themes: how the desktop looks: themes, scale and icons. Open {@link org.pendant.kit.theme.Look}
 * first.
 */
package org.pendant.kit.theme;
