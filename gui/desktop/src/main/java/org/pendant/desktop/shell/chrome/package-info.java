/**
 * Window chrome: what is always visible around the views: header, rail, status line and footer.
 * Open {@link org.pendant.desktop.shell.chrome.Footer} first.
 */
package org.pendant.desktop.shell.chrome;
