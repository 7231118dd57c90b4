/** What the modules below the window say, in the language of the window. */
package org.pendant.desktop.text;
