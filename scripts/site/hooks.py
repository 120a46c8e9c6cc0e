"""Makes the menu of the pages' indexes, and text of links that leave the site."""
import pathlib
import posixpath
import re

DOCS = "libcontact/docs"
LINK = re.compile(r"\[([^\]]*)\]\(([^)\s]+)\)")


def resolved(target, page):
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), target))


def menu(folder, docs):
    """The pages of a folder in the order of its index, by its headings."""
    index = f"{DOCS}/{folder}/index.md"
    groups = [("", [index])]
    for line in (docs / index).read_text().split("\n"):
        if line.startswith("## "):
            groups.append((line[3:], []))
        for text, target in LINK.findall(line):
            page = resolved(target, index)
            ours = posixpath.dirname(page) == f"{DOCS}/{folder}"
            if page.endswith(".md") and (ours or page == "data/README.md"):
                groups[-1][1].append({text[0].upper() + text[1:]: page})
    entries = groups[0][1]
    entries += [{title: pages} for title, pages in groups[1:] if pages]
    return entries


def on_config(config):
    docs = pathlib.Path(config["docs_dir"])
    tabs = ["Tutorials", "How-to", "Explanation", "Reference", "Internals"]
    config["nav"] = [{"Home": "index.md"}]
    config["nav"] += [{tab: menu(tab.lower(), docs)} for tab in tabs]
    config["nav"][-1]["Internals"].append({"Contributing": "CONTRIBUTING.md"})
    config["nav"].append({"Changes": "CHANGELOG.md"})
    return config


def on_page_markdown(markdown, page, config, files):
    """Links to the README lead home; links to files outside the site become text."""
    known = {file.src_path for file in files}

    def on_site(link):
        text, target = link[1], link[2]
        if re.match(r"[a-z]+:|#", target):
            return link[0]
        path, mark, anchor = target.partition("#")
        place = resolved(path, page.file.src_path)
        if place == "README.md":
            place = "index.md"
        if place not in known:
            return text
        here = posixpath.dirname(page.file.src_path) or "."
        return f"[{text}]({posixpath.relpath(place, here)}{mark}{anchor})"

    if page.file.src_path == f"{DOCS}/reference/index.md":
        doxygen = '<a href="../../../cpp/index.html">Doxygen pages</a>'
        markdown = markdown.replace("Doxygen pages", doxygen)
    return LINK.sub(on_site, markdown)


def on_post_build(config):
    """The index of the search once more, as a script: see theme/main.html."""
    folder = pathlib.Path(config["site_dir"]) / "search"
    index = (folder / "search_index.json").read_text()
    script = f"window.__search = {{index: Promise.resolve({index})}};\n"
    (folder / "search_index.js").write_text(script)
